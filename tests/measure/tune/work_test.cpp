// The amount of work that is measured, on devices of any speed, and its scenes.
#include "host/measure/tune/work.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/measure/tune/made_rows.h"
#include "tests/trace/reference/default_settings.h"
#include "tests/trace/render/one_shot_renderer.h"

namespace candela::tune {
namespace {

// A renderer whose time follows from its speed, plus some time for each render.
class MadeRenderer final : public test::OneShotRenderer {
 public:
  explicit MadeRenderer(double samplesPerSecond, std::uint32_t stopAfter = 1000)
      : samplesPerSecond_(samplesPerSecond), stopAfter_(stopAfter) {}

  render::RenderResult renderOnce(const scene::Scene&, const render::RenderSettings& settings,
                                  const render::RenderControl& control) override {
    renders.push_back(settings);
    render::RenderResult result;
    result.film = image::Film(1, 1);
    result.statistics.seconds["trace"] = secondsOf(settings) * (renders.size() <= coldRenders ? 4 : 1);
    result.statistics.samples = 10;
    if (control.progress) control.progress(1, 10);
    result.interrupted = renders.size() > stopAfter_;
    return result;
  }
  double secondsOf(const render::RenderSettings& s) const {
    return 1e-4 +
           static_cast<double>(s.image.size.width) * s.image.size.height * s.image.sampleCount / samplesPerSecond_;
  }

  std::vector<render::RenderSettings> renders;
  std::size_t coldRenders = 0;  ///< the first ones take four times as long

 private:
  double samplesPerSecond_;
  std::uint32_t stopAfter_;
};

Work workOf(render::Extent size) {
  Work work{.scene = {}, .settings = render::defaultSettings()};
  work.scene.name = "made";
  work.settings.image.size = size;
  return work;
}

TEST_CASE("a run takes a fifth of a second on devices of any speed that allows it") {
  for (const double speed : {1e5, 1e6, 1e7, 1e8, 1e9, 1e10}) {
    INFO(speed);
    MadeRenderer renderer(speed);
    Work work = workOf({640, 400});
    fitToDevice(renderer, {}, {}, work);
    CHECK(renderer.secondsOf(work.settings) > 0.4 * kRunSeconds);
    CHECK(renderer.secondsOf(work.settings) < 1.6 * kRunSeconds);
    CHECK(work.settings.image.size.width / 1.6 == Approx(work.settings.image.size.height).margin(1));
  }
}

TEST_CASE("on a GPU, the work is chosen at the clock of timed runs") {
  MadeRenderer renderer(1e8, 100000);
  renderer.onGpu = true;
  renderer.coldRenders = 100;
  Work work = workOf({640, 400});
  fitToDevice(renderer, {}, {}, work);
  CHECK(renderer.secondsOf(work.settings) > 0.4 * kRunSeconds);
}

TEST_CASE("the image grows to the scene's size before it gets more than one sample per pixel") {
  MadeRenderer slow(5e5);
  Work work = workOf({640, 400});
  fitToDevice(slow, {}, {}, work);
  CHECK(work.settings.image.sampleCount == 1);
  CHECK(work.settings.image.size.width > 128);
  CHECK(work.settings.image.size.width < 640);
  MadeRenderer fast(1e8);
  work = workOf({640, 400});
  fitToDevice(fast, {}, {}, work);
  CHECK(extentText(work.settings.image.size) == "640x400");
  CHECK(work.settings.image.sampleCount > 10);
}

TEST_CASE("requested sizes and sample counts do not change") {
  MadeRenderer renderer(1e6);
  Work work = workOf({640, 400});
  fitToDevice(renderer, {render::Extent{8, 6}, 3}, {}, work);
  CHECK(extentText(work.settings.image.size) == "8x6");
  CHECK(work.settings.image.sampleCount == 3);
  CHECK(renderer.renders.empty());
  fitToDevice(renderer, {render::Extent{64, 60}, {}}, {}, work);
  CHECK(extentText(work.settings.image.size) == "64x60");
  CHECK(work.settings.image.sampleCount > 10);
  work = workOf({640, 400});
  fitToDevice(renderer, {{}, 3}, {}, work);
  CHECK(work.settings.image.sampleCount == 3);
  CHECK(work.settings.image.size.width > 128);
}

TEST_CASE("every candidate renders every scene with its own choices and no other difference") {
  MadeRenderer renderer(1e6);
  const std::vector<Work> works{workOf({8, 8}), workOf({16, 16})};
  const std::vector<Candidate> candidates{builtIn(), candidateWith({{"layout", "bvh2"}, {"workgroup", "32x1"}})};
  const std::vector<Row> rows = measureWork(renderer, works, candidates, 2, {});
  REQUIRE(rows.size() == 2);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(rows[i].candidate == candidates[i]);
    CHECK(rows[i].agrees());
    REQUIRE(rows[i].scenes.size() == 2);
    CHECK(rows[i].scenes[1].measurement.traceSeconds.size() == 2);
  }
  REQUIRE(renderer.renders.size() == 8);
  for (std::size_t i = 0; i < renderer.renders.size(); ++i) {
    const render::RenderSettings& settings = renderer.renders[i];
    CHECK(settings.image.size.width == (i < 4 ? 8 : 16));
    CHECK(extentText(settings.execution.workgroupInUse()) == (i % 2 == 0 ? "8x8" : "32x1"));
    CHECK(settings.execution.automatic.bvhLayout == (i % 2 == 0 ? render::BvhLayout::cwbvh : render::BvhLayout::bvh2));
    CHECK(settings.structure.bvhLayout == render::BvhLayout::automatic);
    CHECK_FALSE(settings.execution.workgroup);
  }
}

TEST_CASE("progress increases once from 0 to 1 for any number of scenes") {
  MadeRenderer renderer(1e6);
  const std::vector<Work> works{workOf({8, 8}), workOf({16, 16})};
  std::vector<double> fractions;
  std::vector<std::uint64_t> samples;
  render::RenderControl control;
  control.progress = [&](double fraction, std::uint64_t done) {
    fractions.push_back(fraction);
    samples.push_back(done);
  };
  measureWork(renderer, works, std::vector<Candidate>{builtIn()}, 2, control);
  CHECK(fractions == std::vector{0.25, 0.5, 0.75, 1.0});
  CHECK(samples == std::vector<std::uint64_t>{10, 20, 30, 40});
}

TEST_CASE("Ctrl-C interrupts the measurement at any time") {
  for (const std::uint32_t renders : {0u, 1u, 3u}) {
    MadeRenderer renderer(1e6, renders);
    std::vector<Work> works{workOf({640, 400})};
    const auto run = [&] {
      fitToDevice(renderer, {}, {}, works.front());
      measureWork(renderer, works, std::vector<Candidate>{builtIn()}, 3, {});
    };
    CHECK_THROWS_AS(run(), InterruptedError);
  }
}

TEST_CASE("the built-in scenes are a small box and a mesh of some hundred thousand triangles, both lit") {
  const std::vector<scene::Scene> scenes = builtInScenes();
  REQUIRE(scenes.size() == 2);
  CHECK(scenes[0].primitives.size() == 68);
  CHECK(scenes[1].primitives.size() == 99392);
  for (const scene::Scene& scene : scenes) {
    CHECK(scene.camera);
    CHECK(std::ranges::any_of(scene.materials, [](const scene::Material& m) { return m.emission != glm::vec3(0); }));
  }
}

}  // namespace
}  // namespace candela::tune
