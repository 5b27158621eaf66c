// A crop has the pixels of the full image, bit for bit, with every tracer and kernel.
#include <catch2/catch.hpp>

#include "tests/trace/render/both_tracers.h"

using namespace candela;
using namespace candela::device;

namespace {

constexpr render::Window kCrop{13, 7, 19, 22};

void requireCropOf(const image::Film& crop, const image::Film& full) {
  REQUIRE(crop.width() == kCrop.width);
  REQUIRE(crop.height() == kCrop.height);
  image::Film expected(kCrop.width, kCrop.height);
  for (std::uint32_t y = 0; y < kCrop.height; ++y) {
    for (std::uint32_t x = 0; x < kCrop.width; ++x) expected.at(x, y) = full.at(kCrop.x + x, kCrop.y + y);
  }
  CHECK(crop.hash() == expected.hash());
}

void requireCropped(const RenderFunction& render, const scene::Scene& scene, render::RenderSettings settings) {
  const render::RenderResult full = render(scene, settings);
  settings.image.crop = kCrop;
  const render::RenderResult crop = render(scene, settings);
  requireCropOf(crop.film, full.film);
  CHECK(crop.statistics.samples == std::uint64_t{kCrop.width} * kCrop.height * settings.image.sampleCount);
}

render::RenderSettings croppedSettings() {
  render::RenderSettings settings = squareSettings(40, 4);
  settings.image.maxDepth = 6;
  return settings;
}

}  // namespace

TEST_CASE("a crop has the pixels of the full image, with the path tracer") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  onBothTracers([&](const RenderFunction& render) { requireCropped(render, scene, croppedSettings()); });
}

TEST_CASE("a crop has the pixels of the full image, with the wavefront kernel", "[swiftshader-slow]") {
  render::RenderSettings settings = croppedSettings();
  settings.execution.kernel = render::KernelKind::wavefront;
  requireCropped(renderOnDevice, loadTestScene("cornell.p3f"), settings);
}

TEST_CASE("a crop has the pixels of the full image, with Whitted's tracer and in views", "[swiftshader-slow]") {
  const scene::Scene scene = primitivesUnderLights();
  const render::Integrator integrator = GENERATE(render::Integrator::whitted, render::Integrator::ao);
  render::RenderSettings settings = croppedSettings();
  settings.image.integrator = integrator;
  onBothTracers([&](const RenderFunction& render) { requireCropped(render, scene, settings); });
}

TEST_CASE("a crop has the pixels of the full image, in bands and small tiles") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  const auto renderer = makeGpuRenderer(testDevice(),
                                        {.loopLimit = std::nullopt, .form = std::nullopt, .maxBandBytes = 8 << 10});
  render::RenderSettings settings = croppedSettings();
  const render::RenderResult full = renderOnDevice(scene, settings);
  settings.image.crop = kCrop;
  settings.execution.tile = render::Extent{7, 5};
  requireCropOf(renderer->render(scene, settings, {}).film, full.film);
}
