// The paired test on renderers whose mean is known: its level with rare flips and one-way devices, its power, its
// margin.
#include "host/judge/verify/paired_test.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/judge/verify/verify.h"
#include "tests/judge/verify/paired_renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::verify {
namespace {

using Catch::Contains;

LightTestResult runPaired(const PairedOptions& options, std::uint32_t seed, const LightTestOptions& test = {},
                          render::Extent size = {32, 32}, const render::RenderControl& control = {}) {
  PairedRenderer device(PairedRole::device, options);
  PairedRenderer reference(PairedRole::reference, options);
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = size;
  settings.image.seed = seed;
  return testLightPaired(scene::Scene{}, settings, device, reference, test, 1, control);
}

PairedOptions pairedBrighterBy(double share) {
  return {.factor = [share](std::uint32_t, std::uint32_t) { return 1 + share; }};
}

int pairedAlarmsOf(int runs, const PairedOptions& options, const LightTestOptions& test) {
  int alarms = 0;
  for (int i = 0; i < runs; ++i) alarms += runPaired(options, static_cast<std::uint32_t>(i), test).differs() ? 1 : 0;
  return alarms;
}

TEST_CASE("rounding and flips raise no more alarms than the level, even on a device that always brightens") {
  for (const double flips : {0.0, 1e-4, 1e-2, 0.3}) {
    for (const bool oneWay : {false, true}) {
      CAPTURE(flips, oneWay);
      CHECK(pairedAlarmsOf(40, {.flips = flips, .jump = 5, .oneWay = oneWay}, {.alpha = 0.05, .timeLimit = 0.0}) <= 6);
    }
  }
}

TEST_CASE("all looks together keep the level") {
  CHECK(pairedAlarmsOf(40, {.flips = 0.01, .jump = 5, .oneWay = true}, {.alpha = 0.05, .bias = 0.2}) <= 6);
}

TEST_CASE("a bias of 0.05 % is found at the first look where nothing is amplified") {
  for (const double bias : {5e-4, -5e-4}) {
    const LightTestResult result = runPaired(pairedBrighterBy(bias), 1);
    CHECK(result.differs());
    CHECK(result.looks == 1);
    CHECK(result.image().relativeDifference() == Approx(bias).epsilon(1e-3));
  }
  const LightTestResult same = runPaired({}, 1);
  CHECK_FALSE(same.differs());
  CHECK(same.information == 1);
  CHECK(same.image().detectableBias < 5e-4);
  CHECK(same.image().margin == Approx(2e-7).epsilon(0.1));
}

TEST_CASE("a bias of the promised size is found in 99 of 100 runs, among flips") {
  PairedOptions options{.flips = 1e-3, .jump = 3};
  options.factor = [](std::uint32_t, std::uint32_t) { return 1.03; };
  CHECK(pairedAlarmsOf(60, options, {.bias = 0.03}) >= 59);
}

TEST_CASE("looks go on until the bias would be detected, also if the first ones underestimate the noise") {
  const LightTestResult result = runPaired({.flips = 1e-3, .jump = 3}, 11, {.bias = 3.3e-3}, {64, 64});
  CHECK_FALSE(result.differs());
  CHECK(result.looks > kMaxLooks);
  CHECK(result.information == 1);
}

TEST_CASE("a paired bias of one tile of 0.02 % is found there") {
  const auto factor = [](std::uint32_t x, std::uint32_t y) { return x >= 8 && x < 16 && y < 8 ? 1.0002 : 1.0; };
  const LightTestResult result = runPaired({.factor = factor}, 3);
  REQUIRE(result.differs());
  for (const RegionResult& tile : result.regions) {
    if (tile.region.tileSize == 8) CHECK(tile.differs == (tile.region.x == 8 && tile.region.y == 0));
  }
}

TEST_CASE("a bias below the margin ends the run at its first look, and is not decided") {
  const PairedOptions options{.flips = 0.01, .jump = 1};
  const LightTestResult refused = runPaired(options, 1, {.bias = 1e-3});
  CHECK(refused.looks == 1);
  CHECK(refused.information < 1);
  CHECK(doubtOf(refused.image(), 1e-3) == Doubt::rounding);
  const LightTestResult result = runPaired({.flips = 0.02, .jump = 1}, 1);
  CHECK(result.bias > 0.05);
  CHECK(result.bias < 0.1);
}

TEST_CASE("a run that noise would leave undecided goes on until it detects 1 %") {
  const PairedOptions rareFlips{.flips = 1e-4, .jump = 20};
  const LightTestResult result = runPaired(rareFlips, 4);
  const LightTestResult shorter = runPaired(rareFlips, 4, {.timeLimit = 0.0});
  CAPTURE(result.samplesPerPixel, result.image().detectableBias);
  CHECK(doubtOf(shorter.image(), kMaxOverlooked) == Doubt::noise);
  CHECK(doubtOf(result.image(), kMaxOverlooked) == Doubt::none);
  CHECK(result.samplesPerPixel > kDefaultSamples);
  CHECK(result.samplesPerPixel > shorter.samplesPerPixel);
}

TEST_CASE("images of few pixels have enough values by more batches") {
  const LightTestResult result = runPaired(pairedBrighterBy(0.01), 1, {}, {4, 2});
  CHECK(result.differs());
  CHECK(result.samplesPerPixel == 8192);
}

TEST_CASE("batches of integrators that do not jitter a single sample have two") {
  PairedRenderer device(PairedRole::device, {}), reference(PairedRole::reference, {});
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {64, 64};
  for (const auto& [integrator, samples] :
       {std::pair{render::Integrator::path, 16u}, {render::Integrator::whitted, 32u}}) {
    settings.image.integrator = integrator;
    CHECK(testLightPaired(scene::Scene{}, settings, device, reference, {}, 1, {}).samplesPerPixel == samples);
  }
}

TEST_CASE("black against black agrees") {
  const PairedOptions black{.rounding = 0, .factor = [](std::uint32_t, std::uint32_t) { return 0.0; }};
  PairedRenderer device(PairedRole::device, black), same(PairedRole::device, black);
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {16, 16};
  const LightTestResult result = testLightPaired(scene::Scene{}, settings, device, same, {}, 0, {});
  CHECK_FALSE(result.differs());
  CHECK(result.information == 1);
}

TEST_CASE("a time limit ends the run after the current look, and an interrupted run has no verdict") {
  const LightTestResult result = runPaired({.flips = 0.01, .jump = 50}, 1, {.timeLimit = 0.0});
  CHECK(result.looks == 1);
  const std::atomic<bool> stop = true;
  render::RenderControl control;
  control.stop = &stop;
  CHECK(runPaired({}, 1, {}, {16, 16}, control).interrupted);
}

TEST_CASE("loops that a device ends early in the images of one sample are counted, and end a verdict") {
  const PairedOptions options{.rounding = 0, .truncated = 3};
  PairedRenderer device(PairedRole::device, options);
  PairedRenderer reference(PairedRole::reference, options);
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {16, 16};
  settings.image.sampleCount = 4;
  CHECK(compareTracers(scene::Scene{}, settings, device, reference, {}, {}).deviceStatistics.truncated == 3);
  CHECK_THROWS_WITH(verifyScene(scene::Scene{}, settings, device, reference, {}, {}),
                    Contains("stopped 3 loops early"));
}

}  // namespace
}  // namespace candela::verify
