// Device and reference draw the same numbers, so they give the same picture, sample by sample.
#include <catch2/catch.hpp>

#include "host/formats/load_scene.h"
#include "host/judge/verify/agreement.h"
#include "tests/trace/light_tree_scenes.h"
#include "tests/trace/render/render_support.h"

using namespace candela;
using namespace candela::device;

namespace {

render::RenderSettings settingsFor(const scene::Scene& scene, std::uint32_t side, bool nextEventEstimation) {
  render::RenderSettings settings = squareSettings(side, 1);
  settings.image.nextEventEstimation = nextEventEstimation;
  settings.image.oneSided = scene.name == "mirror.p3f";  // its camera looks through the back of a wall
  return settings;
}

// Requires that pictures with one sample per pixel agree.
void requireSamePixels(const scene::Scene& scene, render::RenderSettings settings) {
  settings.execution.recordPaths = true;
  const verify::PixelAgreement pixels = verify::comparePixels(renderOnDevice(scene, settings),
                                                              renderOnReference(scene, settings));
  CAPTURE(scene.name, settings.image.nextEventEstimation, pixels.equalFraction(), pixels.litEqualFraction(), pixels.lit,
          pixels.causes, pixels.worst, pixels.worstX, pixels.worstY);
  CHECK(pixels.equalFraction() >= kRequiredEqualFraction);
  CHECK(pixels.litEqualFraction() >= kRequiredLitEqualFraction);
}

void requireSameScenes(std::uint32_t side, bool nextEventEstimation) {
  for (const auto& file : sceneFiles()) {
    const scene::Scene scene = formats::loadScene(file).scene;
    requireSamePixels(scene, settingsFor(scene, side, nextEventEstimation));
  }
}

void requireSameMeans(std::uint32_t side, std::uint32_t samples) {
  for (const auto& file : sceneFiles()) {
    const scene::Scene scene = formats::loadScene(file).scene;
    for (const bool nextEventEstimation : {true, false}) {
      render::RenderSettings settings = settingsFor(scene, side, nextEventEstimation);
      settings.image.sampleCount = samples;
      const double device = meanLuminance(renderOnDevice(scene, settings).film);
      const double reference = meanLuminance(renderOnReference(scene, settings).film);
      CAPTURE(scene.name, nextEventEstimation);
      CHECK(device == Approx(reference).epsilon(kMeanTolerance));
    }
  }
}

}  // namespace

TEST_CASE("every scene has the reference's pixels at one sample, with light sampling") { requireSameScenes(80, true); }

TEST_CASE(
    "a room under lights of a tree has the reference's pixels and, at more samples, those of lights chosen by power",
    "[swiftshader-slow]") {
  const scene::Scene scene = GENERATE(test::litRoom(120, 7), test::litRoom(40, 8, 30));
  render::RenderSettings settings = squareSettings(80, 1);
  settings.image.lights = render::LightSelection::tree;
  requireSamePixels(scene, settings);
  settings.image.sampleCount = 256;
  const double byTree = meanLuminance(renderOnDevice(scene, settings).film);
  settings.image.lights = render::LightSelection::power;
  CHECK(byTree == Approx(meanLuminance(renderOnDevice(scene, settings).film)).epsilon(0.01));
}

TEST_CASE("every scene has the reference's pixels at one sample, without light sampling", "[swiftshader-slow]") {
  requireSameScenes(80, false);
}

TEST_CASE("every scene has the reference's pixels at one sample in images of 256 x 256", "[slow]") {
  requireSameScenes(256, true);
  requireSameScenes(256, false);
}

TEST_CASE("every scene has the reference's mean at 64 samples", "[slow]") { requireSameMeans(64, 64); }

// Hours on SwiftShader.
TEST_CASE("every scene has the reference's mean at 64 samples in images of 256 x 256", "[slow]") {
  requireSameMeans(256, 64);
}

TEST_CASE("samplers, filters and lenses agree with the reference", "[swiftshader-slow]") {
  using enum render::SamplerKind;
  using enum render::FilterKind;
  using enum render::LensKind;
  // Every filter with every lens, every sampler at least once.
  const auto [sampler, filter, lens] = GENERATE(table<render::SamplerKind, render::FilterKind, render::LensKind>(
      {{render::SamplerKind::independent, box, render::LensKind::square},
       {render::SamplerKind::stratified, render::FilterKind::tent, render::LensKind::disc},
       {render::SamplerKind::sobol, box, render::LensKind::disc},
       {render::SamplerKind::sobol, render::FilterKind::tent, render::LensKind::square},
       {render::SamplerKind::independent, gaussian, render::LensKind::disc},
       {render::SamplerKind::sobol, gaussian, render::LensKind::square}}));
  const scene::Scene scene = loadTestScene("depth_of_field.p3f");
  render::RenderSettings settings = squareSettings(64, 1);
  settings.image.sampler = sampler;
  settings.image.filter = {filter, 0.8f};
  settings.image.lens = lens;
  requireSamePixels(scene, settings);
}

TEST_CASE("depth limit and roulette agree with the reference") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  render::RenderSettings settings = squareSettings(64, 1);
  settings.image.maxDepth = GENERATE(1u, 2u, 5u);
  settings.image.rouletteStart = GENERATE(0u, 2u);
  requireSamePixels(scene, settings);
}

// Objects on a floor: a sphere that is visible only from inside, with the camera outside; a flat box of glass; a box so
// thin that it is flat at its distance; a light that transmits light; a mixture scaled to 1 in white light; and, above
// them, the back of a triangle with vertex normals.
const char* const kSeldomMet = R"(
b 0.3 0.4 0.5
v
from 0.3 -14 5
at 0 0 0
up 0 0 1
angle 40
hither 0
resolution 8 8
l 3 -3 4 1 1 1
f 0.7 0.6 0.5 1 0 0 0 0 1 0 1 0 0 0
pl 0 0 -1 1 0 -1 0 1 -1
s -4.4 0 0 -1
f 0.9 0.9 0.9 0 0 0 0 0 1 1 1.5 0 0 0
box -3.2 -0.5 0 -1.2 0.5 0
f 0.9 0.9 0.9 1 0 0 0 0 1 0 1 0 0 0
box -1 -0.5 0.2 1 0.5 0.2000001
f 0.5 0.5 0.5 0.5 1 1 1 0.2 20 0.3 1.4 3 2 1
p 3
1.2 0 -0.5
2.2 1 1
3.2 0 -0.5
f 0.8 0.8 0.8 0 1 1 1 0.5 50 0.5 1.3 0 0 0
c
4.4 0 -1 0.8
4.4 0 1 0.2
f 0.8 0.7 0.6 1 0 0 0 0 1 0 1 0 0 0
pp 3
-3 0 1.4 -0.5 0.8 0.1
-1 0 4.2 0 0.8 0.5
1 0 1.4 0.5 0.8 0.1
)";

TEST_CASE("rules for unusual scenes agree with the reference", "[swiftshader-slow]") {
  const scene::Scene scene = sceneFromText(kSeldomMet);
  render::RenderSettings settings = squareSettings(128, 1);
  settings.image.nextEventEstimation = GENERATE(true, false);
  settings.image.oneSided = GENERATE(false, true);
  CAPTURE(settings.image.oneSided);
  requireSamePixels(scene, settings);
}

TEST_CASE("walls of radius 1e5 show neither acne nor leaks") {
  const scene::Scene scene = loadTestScene("smallpt.p3f");
  render::RenderSettings settings = squareSettings(96, 4);
  settings.image.nextEventEstimation = GENERATE(true, false);
  const image::Film device = renderOnDevice(scene, settings).film;
  const image::Film reference = renderOnReference(scene, settings).film;
  // Acne darkens and leaks brighten: pixel by pixel, with the same samples, almost no pixel may differ.
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

TEST_CASE("both tracers count the same volume faults, with Russian roulette and rejected directions") {
  scene::Material glass;
  glass.surface = {.roughness = 0.5f, .transmissionWeight = 1, .isThinWalled = false, .absorption = glm::vec3(2)};
  test::SceneBuilder b;
  b.material(glass).box({-50, -50, -1}, {50, 50, 0}).material(glass).box({-50, -50, -2}, {50, 50, -0.5f});
  b.scene.background = glm::vec3(1);
  b.view({0, -2, 1.5f}, {0, 0, 0}, {0, 0, 1}, 60);
  render::RenderSettings settings = squareSettings(64, 16);
  settings.image.rouletteStart = 0;
  const auto faults = [&](const auto& render) {
    return static_cast<double>(render(b.scene, settings).statistics.volumeFaults);
  };
  const double expected = faults(renderOnReference);
  CHECK(expected > 64 * 64 * 4);
  CHECK(faults(renderOnDevice) == Approx(expected).epsilon(1e-3));
}
