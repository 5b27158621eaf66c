// The sequential test on images whose mean is known: its false alarms, its power, and its end.
#include "host/judge/verify/light_test.h"

#include <catch2/catch.hpp>

#include "tests/judge/verify/noise_renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::verify {
namespace {

LightTestResult run(const NoiseOptions& device, std::uint32_t seed, const LightTestOptions& options = {},
                    const render::RenderControl& control = {}) {
  NoiseRenderer a(device);
  NoiseRenderer b;
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {16, 16};
  settings.image.seed = seed;
  return testLight(scene::Scene{}, settings, a, b, options, control);
}

NoiseOptions brighterBy(double share) {
  return {.factor = [share](std::uint32_t, std::uint32_t) { return 1 + share; }};
}

int alarmsOf(int runs, const NoiseOptions& device, const LightTestOptions& options) {
  int alarms = 0;
  for (int i = 0; i < runs; ++i) alarms += run(device, static_cast<std::uint32_t>(i), options).differs() ? 1 : 0;
  return alarms;
}

TEST_CASE("equal light raises no alarm at the default level, and the expected number at another") {
  CHECK(alarmsOf(200, {}, {}) == 0);
  const int alarms = alarmsOf(200, {}, {.alpha = 0.05});
  CHECK(alarms >= 2);
  CHECK(alarms <= 21);
}

TEST_CASE("a bias of the requested size is detected in 99 of 100 runs, on either side") {
  CHECK(alarmsOf(100, brighterBy(0.005), {}) >= 99);
  CHECK(alarmsOf(100, brighterBy(-0.005), {}) >= 99);
}

TEST_CASE("a run takes the samples that this detection needs, and not many more") {
  const LightTestResult result = run({}, 1);
  CHECK(result.information == 1);
  CHECK(result.image().detectableBias < 0.006);
  CHECK(result.image().detectableBias > 0.0025);
  CHECK(run({}, 1, {.bias = 0.05}).samplesPerPixel < result.samplesPerPixel / 20);
}

TEST_CASE("a bias of one tile is reported at this tile although the image mean hardly changes") {
  const NoiseOptions oneTile{.factor = [](std::uint32_t x, std::uint32_t y) { return x >= 8 && y < 8 ? 1.05 : 1.0; }};
  const LightTestResult result = run(oneTile, 3);
  REQUIRE(result.differs());
  CHECK_FALSE(run({}, 3).differs());
  bool found = false;
  for (const RegionResult& region : result.regions) {
    if (region.region.tileSize == 8 && region.differs) {
      CHECK(region.region.x == 8);
      CHECK(region.region.y == 0);
      found = true;
    }
  }
  CHECK(found);
}

TEST_CASE("images without noise are equal up to rounding, or differ at the first look") {
  NoiseOptions exact{.deviation = 0};
  const auto compare = [&](double factor) {
    NoiseRenderer a({.deviation = 0, .factor = [factor](std::uint32_t, std::uint32_t) { return factor; }});
    NoiseRenderer b(exact);
    render::RenderSettings settings = render::defaultSettings();
    settings.image.size = {16, 16};
    return testLight(scene::Scene{}, settings, a, b, {}, {});
  };
  CHECK_FALSE(compare(1 + 1e-6).differs());
  CHECK(compare(1 + 1e-6).looks == 1);
  CHECK(compare(1.001).differs());
}

TEST_CASE("a black image agrees with a black one and differs from a lit one") {
  const NoiseOptions black{.factor = [](std::uint32_t, std::uint32_t) { return 0.0; }};
  NoiseRenderer a(black), b(black);
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {16, 16};
  CHECK_FALSE(testLight(scene::Scene{}, settings, a, b, {}, {}).differs());
  CHECK(run(black, 1).differs());
}

TEST_CASE("a large difference ends the run at the first look") {
  const LightTestResult result = run(brighterBy(0.5), 1);
  CHECK(result.differs());
  CHECK(result.looks == 1);
}

TEST_CASE("a time limit ends the run after the current look, which reports its information") {
  const LightTestResult result = run({}, 1, {.timeLimit = 0.0});
  CHECK(result.outOfTime);
  CHECK(result.looks == 1);
  CHECK(result.information < 1);
  CHECK(result.image().detectableBias > 0.005);
}

TEST_CASE("an interrupted run has no verdict") {
  const std::atomic<bool> stop = true;
  render::RenderControl control;
  control.stop = &stop;
  CHECK(run({}, 1, {}, control).interrupted);
}

TEST_CASE("looks grow at least twofold towards the required information") {
  CHECK(informationFraction(1, 1, 2) == Approx(std::pow(1 / (2 + 2.3263479), 2)));
  CHECK(informationFraction(0.1, 1, 2) == 1);
  CHECK(nextSamples(10, 0.5, 7) == 20);
  CHECK(nextSamples(100, 0.9, 7) == 123);
  CHECK(nextSamples(100, 0.01, 1) == 11000);
  CHECK(nextSamples(1, 1e-7, 7) == 11);
}

}  // namespace
}  // namespace candela::verify
