// Device and reference draw the same numbers, so they give the same picture, sample by sample.
#include <catch2/catch.hpp>

#include "host/render/agreement.h"
#include "tests/render/render_support.h"

using namespace candela;

namespace {

RenderSettings settingsFor(const Scene& scene, std::uint32_t side, bool nextEventEstimation) {
  RenderSettings settings = squareSettings(side, 1);
  settings.nextEventEstimation = nextEventEstimation;
  settings.oneSided = scene.name == "mirror.p3f";  // its camera looks through the back of a wall
  return settings;
}

// Of pictures of one sample per pixel.
void requireSamePixels(const Scene& scene, RenderSettings settings) {
  settings.recordPaths = true;
  const PixelAgreement pixels = comparePixels(renderOnDevice(scene, settings), renderOnReference(scene, settings));
  CAPTURE(scene.name, settings.nextEventEstimation, pixels.share(), pixels.litShare(), pixels.lit, pixels.causes,
          pixels.worst, pixels.worstX, pixels.worstY);
  CHECK(pixels.share() >= kRequiredShare);
  CHECK(pixels.litShare() >= kRequiredLitShare);
}

void requireSameMean(const Scene& scene, const RenderSettings& settings) {
  const double device = meanLuminance(renderOnDevice(scene, settings).film);
  const double reference = meanLuminance(renderOnReference(scene, settings).film);
  CAPTURE(scene.name, settings.nextEventEstimation);
  CHECK(device == Approx(reference).epsilon(kMeanTolerance));
}

}  // namespace

TEST_CASE("every scene has the reference's pixels at one sample, with light sampling and without") {
  for (const auto& file : sceneFiles()) {
    const Scene scene = loadScene(file).scene;
    requireSamePixels(scene, settingsFor(scene, 256, true));
    requireSamePixels(scene, settingsFor(scene, 256, false));
  }
}

TEST_CASE("every scene has the reference's mean at 64 samples, with light sampling and without", "[slow]") {
  for (const auto& file : sceneFiles()) {
    const Scene scene = loadScene(file).scene;
    for (const bool nextEventEstimation : {true, false}) {
      RenderSettings settings = settingsFor(scene, 256, nextEventEstimation);
      settings.sampleCount = 64;
      requireSameMean(scene, settings);
    }
  }
}

TEST_CASE("samplers, filters and lenses agree with the reference") {
  const Scene scene = loadTestScene("depth_of_field.p3f");
  RenderSettings settings = squareSettings(64, 1);
  settings.sampler = GENERATE(SamplerKind::independent, SamplerKind::stratified, SamplerKind::sobol);
  settings.filter = GENERATE(FilterKind::box, FilterKind::tent);
  settings.lens = GENERATE(LensKind::disc, LensKind::square);
  requireSamePixels(scene, settings);
}

TEST_CASE("depth limit and roulette agree with the reference") {
  const Scene scene = loadTestScene("cornell.p3f");
  RenderSettings settings = squareSettings(64, 1);
  settings.maxDepth = GENERATE(1u, 2u, 5u);
  settings.rouletteStart = GENERATE(0u, 2u);
  requireSamePixels(scene, settings);
}

TEST_CASE("rules that scenes seldom meet agree with the reference") {
  const std::string view = "b 0.3 0.4 0.5\nv\nfrom 0.3 -6 2\nat 0 0 0\nup 0 0 1\nangle 40\nhither 0\nresolution 8 8\n";
  const std::string floor = "f 0.7 0.6 0.5 1 0 0 0 0 1 0 1 0 0 0\npl 0 0 -1 1 0 -1 0 1 -1\n";
  const std::string object = GENERATE(
      as<std::string>(), "s 0 0 0 -1\n",                                             // from inside only, camera outside
      "f 0.9 0.9 0.9 0 0 0 0 0 1 1 1.5 0 0 0\nbox -1 -0.5 0 1 0.5 0\n",               // flat glass box
      "f 0.9 0.9 0.9 1 0 0 0 0 1 0 1 0 0 0\nbox -1 -0.5 0.2 1 0.5 0.2000001\n",       // thin box, far away for its size
      "f 0.5 0.5 0.5 0.5 1 1 1 0.2 20 0.3 1.4 3 2 1\np 3 -1 0 -0.5 0 1 1 1 0 -0.5\n",  // lamp that lets light through
      "f 0.8 0.8 0.8 0 1 1 1 0.5 50 0.5 1.3 0 0 0\nc 0 0 -1 0.8 0 0 1 0.2\nl 3 -3 4 1 1 1\n");
  const Scene scene = sceneFromText(view + floor + object);
  RenderSettings settings = squareSettings(64, 1);
  settings.nextEventEstimation = GENERATE(true, false);
  settings.oneSided = GENERATE(false, true);
  CAPTURE(object, settings.oneSided);
  requireSamePixels(scene, settings);
}

TEST_CASE("walls of radius 1e5 show neither acne nor leaks") {
  const Scene scene = loadTestScene("smallpt.p3f");
  RenderSettings settings = squareSettings(96, 16);
  settings.nextEventEstimation = GENERATE(true, false);
  const Film device = renderOnDevice(scene, settings).film;
  const Film reference = renderOnReference(scene, settings).film;
  // Acne darkens and leaks brighten: pixel by pixel, with the same samples, next to nothing may differ.
  std::uint32_t different = 0;
  for (std::uint32_t y = 0; y < device.height(); ++y) {
    for (std::uint32_t x = 0; x < device.width(); ++x) {
      const double expected = pixelLuminance(reference, x, y);
      different += std::abs(pixelLuminance(device, x, y) - expected) > 1e-3 * std::max(expected, 1e-3);
    }
  }
  CAPTURE(different);
  CHECK(different < device.width() * device.height() / 50);
  CHECK(meanLuminance(device) == Approx(meanLuminance(reference)).epsilon(1e-3));
}
