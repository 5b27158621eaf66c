// Jobs that share a renderer: what is prepared again, and what a failure leaves.
#include "host/job/frame_renderer.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "host/formats/nff/nff_loader.h"
#include "host/trace/reference/reference_renderer.h"
#include "host/trace/render/request.h"
#include "tests/job/forwarding_session.h"

namespace candela::job {
namespace {

constexpr const char* kView = "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 12 9\n";

/// The scene of a frame: a ball of this colour, seen from this x.
Job frame(float x, float red, std::uint32_t seed = 0) {
  scene::Scene parsed = scene::parseScene(std::string(kView) + "l 2 3 4\nf " + std::to_string(red) +
                                              " 0.5 0.2 1 0 0 0 1\ns 0 0 0 1\n",
                                          "ball.nff", ".")
                            .scene;
  parsed.camera->from.x = x;
  const auto scene = std::make_shared<const scene::Scene>(std::move(parsed));
  render::RenderRequest request;
  request.sampleCount = 2;
  request.image.seed = seed;
  request.execution.threads = 1;
  return {scene, {}, render::resolve(request, *scene), {}};
}

/// Counts how often devices are opened and scenes prepared. Sessions fail while `failures` is above 0.
struct Counts {
  int opened = 0, prepared = 0, failures = 0;
};

class FailingSession final : public ForwardingSession {
 public:
  FailingSession(std::unique_ptr<render::Session> inner, Counts& counts)
      : ForwardingSession(std::move(inner)), counts_(counts) {}

  bool advance(render::SampleRange range, const render::RenderControl& control) override {
    if (counts_.failures-- > 0) throw DeviceLostError("the made device was lost");
    return ForwardingSession::advance(range, control);
  }

 private:
  Counts& counts_;
};

class CountingRenderer final : public render::Renderer {
 public:
  explicit CountingRenderer(Counts& counts) : counts_(counts) { ++counts_.opened; }
  std::unique_ptr<render::Session> prepare(const scene::Scene& scene, const render::RenderSettings& settings) override {
    ++counts_.prepared;
    return std::make_unique<FailingSession>(reference_->prepare(scene, settings), counts_);
  }

 private:
  std::unique_ptr<render::Renderer> reference_ = reference::makeReferenceRenderer();
  Counts& counts_;
};

OpenDevice counting(Counts& counts) {
  return [&counts] { return std::make_unique<CountingRenderer>(counts); };
}

image::Film filmOf(const Job& job) {
  std::ostringstream messages;
  const Log log(messages, Verbosity::quiet);
  return runJob(job, {}, {}, log).result.film;
}

}  // namespace

TEST_CASE("only what differs between two jobs is prepared again, and films are those of single jobs") {
  Counts counts;
  FrameRenderer renderer(counting(counts));
  std::ostringstream messages;
  const Log log(messages, Verbosity::quiet);
  struct Step {
    Job job;
    int prepared;
  };
  for (const Step& step : {Step{frame(0, 1), 1},
                           {frame(1, 1), 1},
                           {frame(1, 1, 9), 1},
                           {frame(1, 0.5f), 2},
                           {frame(2, 0.5f), 2},
                           {frame(2, 1), 3}}) {
    const JobResult result = renderer.run(step.job, {}, log);
    CHECK(result.result.film.hash() == filmOf(step.job).hash());
    CHECK(counts.prepared == step.prepared);
    CHECK(counts.opened == 1);
  }
}

TEST_CASE("the reference keeps its session, too, and a failure of the device is finished by it") {
  std::ostringstream messages;
  const Log log(messages, Verbosity::quiet);
  FrameRenderer alone({});
  alone.run(frame(0, 1), {}, log);
  const JobResult second = alone.run(frame(1, 1), {}, log);
  CHECK(second.result.statistics.seconds.at("build") == 0);
  CHECK(second.result.film.hash() == filmOf(frame(1, 1)).hash());

  Counts counts;
  FrameRenderer renderer(counting(counts));
  Job job = frame(2, 1);
  job.film.fallback = Fallback::reference;
  counts.failures = 4;
  CHECK(renderer.run(job, {}, log).result.film.hash() == filmOf(frame(2, 1)).hash());
  CHECK(counts.failures == 0);
}

TEST_CASE("work that an earlier job did is not counted again") {
  Counts counts;
  FrameRenderer renderer(counting(counts));
  std::ostringstream messages;
  const Log log(messages, Verbosity::quiet);
  CHECK(renderer.run(frame(0, 1), {}, log).result.statistics.seconds.at("build") > 0);
  const render::RenderStatistics second = renderer.run(frame(1, 1), {}, log).result.statistics;
  CHECK(second.seconds.at("build") == 0);
  CHECK(second.samples == 12 * 9 * 2);
}

TEST_CASE("after a failure, the device is opened and the scene prepared again") {
  Counts counts;
  FrameRenderer renderer(counting(counts));
  std::ostringstream messages;
  const Log log(messages, Verbosity::quiet);
  renderer.run(frame(0, 1), {}, log);
  counts.failures = 1;
  CHECK(renderer.run(frame(1, 1), {}, log).result.film.hash() == filmOf(frame(1, 1)).hash());
  CHECK(counts.opened == 2);
  CHECK(counts.prepared == 2);
  counts.failures = 4;
  CHECK_THROWS_AS(renderer.run(frame(2, 1), {}, log), Error);
  counts.failures = 0;
  CHECK(renderer.run(frame(3, 1), {}, log).result.film.hash() == filmOf(frame(3, 1)).hash());
  CHECK(counts.opened == 6);
}

}  // namespace candela::job
