// The test against an exact mean, on renderers whose mean is known: its level, its power, and the side that it names.
#include "host/judge/verify/exact_test.h"

#include <catch2/catch.hpp>

#include "host/judge/verify/paired_test.h"
#include "tests/judge/verify/noise_renderer.h"
#include "tests/judge/verify/paired_renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::verify {
namespace {

constexpr std::uint32_t kImageSize = 32;

// A scene that states a mean of 1 for a quarter of its image.
scene::Scene sceneOfMeanOne() {
  scene::Scene scene;
  scene.exactMean = scene::ExactMean{.rgb = glm::vec3(1), .area = {0.25f, 0.5f, 0.5f, 0.5f}};
  return scene;
}

render::RenderSettings settingsOf(std::uint32_t seed) {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {kImageSize, kImageSize};
  settings.image.seed = seed;
  return settings;
}

LightTestOptions optionsOf(const scene::Scene& scene, LightTestOptions options) {
  options.watched = regionOf(*scene.exactMean, {kImageSize, kImageSize});
  return options;
}

ExactTest runExact(const PairedOptions& paired, std::uint32_t seed, const LightTestOptions& test = {}) {
  const scene::Scene scene = sceneOfMeanOne();
  PairedRenderer device(PairedRole::device, paired);
  PairedRenderer reference(PairedRole::reference, paired);
  const LightTestOptions options = optionsOf(scene, test);
  const render::RenderSettings settings = settingsOf(seed);
  const LightTestResult light = testLightPaired(scene, settings, device, reference, options, 1, {});
  render::BadSampleTallies badSamples;
  return testExactMean(scene, settings, device, reference, options, light, {}, badSamples).value();
}

PairedOptions biased(double deviceFactor, double referenceFactor) {
  PairedOptions options{.referenceFactor = referenceFactor};
  options.factor = [deviceFactor](std::uint32_t, std::uint32_t) { return deviceFactor; };
  return options;
}

TEST_CASE("both sides agree with the exact mean as often as the level states") {
  int alarms = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed)
    alarms += runExact({}, seed, {.alpha = 0.05, .bias = 0.05}).isMet() ? 0 : 1;
  CHECK(alarms <= 9);  // P(more) = 1e-3 at 60 * 0.05 = 3
}

TEST_CASE("an error of both sides is found against the exact mean") {
  const ExactTest test = runExact(biased(1.01, 1.01), 1);
  CHECK(test.devicePValue < test.level);
  CHECK(test.referencePValue < test.level);
  CHECK(test.device == Approx(1.01).epsilon(0.005));
  CHECK(test.reference == Approx(1.01).epsilon(0.005));
  CHECK(test.samplesPerPixel > 1000);
}

TEST_CASE("the side that is wrong is the one that differs from the exact mean") {
  const ExactTest device = runExact(biased(1.01, 1), 1);
  CHECK(device.devicePValue < device.level);
  CHECK(device.referencePValue >= device.level);
  const ExactTest reference = runExact(biased(1, 0.99), 2);
  CHECK(reference.devicePValue >= reference.level);
  CHECK(reference.referencePValue < reference.level);
  CHECK(reference.reference == Approx(0.99).epsilon(0.005));
}

TEST_CASE("where rounding excuses more than 0.5 %, the reference is tested with its own samples") {
  PairedOptions undecidable{.flips = 0.2, .jump = 1};
  undecidable.factor = [](std::uint32_t, std::uint32_t) { return 0.9; };  // its mean is that of the reference, 0.99
  undecidable.referenceFactor = 0.99;
  const ExactTest wrong = runExact(undecidable, 1);
  CHECK(wrong.referenceDiffers());
  CHECK(wrong.reference == Approx(0.99).epsilon(0.005));
  CHECK(wrong.referenceSamplesPerPixel > 1000);
  undecidable.referenceFactor = 1;
  CHECK_FALSE(runExact(undecidable, 1).referenceDiffers());
  CHECK(runExact({}, 1).referenceSamplesPerPixel == 0);
}

TEST_CASE("only the pixels of the stated area are tested") {
  PairedOptions options;
  options.factor = [](std::uint32_t x, std::uint32_t y) { return x < 8 || x >= 24 || y < 16 ? 2.0 : 1.0; };
  const scene::Scene scene = sceneOfMeanOne();
  const Region area = regionOf(*scene.exactMean, {kImageSize, kImageSize});
  CHECK(area.x == 8);
  CHECK(area.y == 16);
  CHECK(area.width == 16);
  CHECK(area.height == 16);
  PairedRenderer device(PairedRole::device, options);
  PairedRenderer reference(PairedRole::reference, options);
  const LightTestOptions test = optionsOf(scene, {});
  const LightTestResult light = testLightPaired(scene, settingsOf(1), device, reference, test, 1, {});
  CHECK(light.differs());
  CHECK(light.watchedDifference.value().relativeDifference() == Approx(0).margin(1e-6));
}

TEST_CASE("the independent test's own batches are compared with the exact mean") {
  scene::Scene scene;
  scene.exactMean = scene::ExactMean{.rgb = glm::vec3(1.5f)};
  NoiseRenderer device({.deviation = 0.1}), reference({.deviation = 0.1});
  const LightTestOptions test = optionsOf(scene, {.method = LightTestMethod::independent});
  const LightTestResult light = testLight(scene, settingsOf(1), device, reference, test, {});
  render::BadSampleTallies badSamples;
  const std::uint64_t before = device.samples;
  const ExactTest exact = testExactMean(scene, settingsOf(1), device, reference, test, light, {}, badSamples).value();
  CHECK(device.samples == before);
  CHECK(exact.samplesPerPixel == 0);
  CHECK(exact.device == Approx(2.55).epsilon(0.01));  // the ramp's mean
  CHECK_FALSE(exact.isMet());
}

}  // namespace
}  // namespace candela::verify
