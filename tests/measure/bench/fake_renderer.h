// A renderer that takes no time: its images and figures are scripted.
#pragma once
#include <vector>

#include "host/trace/render/renderer.h"
#include "tests/trace/render/one_shot_renderer.h"

namespace candela::bench {

/// One run: the value of the film's only pixel, and the statistics.
struct ScriptedRun {
  float value = 1;
  double traceSeconds = 1;
  std::uint64_t truncated = 0;
  bool interrupted = false;
};

class FakeRenderer final : public test::OneShotRenderer {
 public:
  explicit FakeRenderer(std::vector<ScriptedRun> runs) : runs_(std::move(runs)) {}

  render::RenderResult renderOnce(const scene::Scene&, const render::RenderSettings& settings,
                                  const render::RenderControl& control) override {
    const ScriptedRun& run = runs_.at(accels.size());
    accels.push_back(settings.structure.accel);
    seeds.push_back(settings.image.seed);
    sampleCounts.push_back(settings.image.sampleCount);
    render::RenderResult result;
    result.film = image::Film(1, 1);
    result.film.addSample(0, 0, glm::dvec3(run.value), 0);
    result.statistics.samples = 1000;
    result.statistics.cameraRays = 1000;
    result.statistics.shadowRays = 500;
    result.statistics.traversalSteps = 6000;
    result.statistics.truncated = run.truncated;
    result.statistics.seconds = {{"trace", run.traceSeconds}, {"structure", 0.25 * run.traceSeconds}};
    result.statistics.structure = settings.structure.accel == render::AccelKind::grid ? render::AccelKind::grid
                                                                                      : render::AccelKind::bvh;
    result.statistics.bvhSplit = settings.structure.bvhSplit == render::BvhSplit::sah ? render::SplitInUse::sah
                                                                                      : render::SplitInUse::midpoint;
    result.interrupted = run.interrupted;
    if (control.progress) control.progress(1, 1000);
    return result;
  }

  std::vector<render::AccelKind> accels;  ///< of the runs so far, in their order
  std::vector<std::uint32_t> seeds;
  std::vector<std::uint32_t> sampleCounts;

 private:
  std::vector<ScriptedRun> runs_;
};

}  // namespace candela::bench
