// Samples that the film cannot represent are counted in their pixels, on both sides.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/trace/render/render_support.h"

using namespace candela;
using namespace candela::device;

namespace {

// A light brighter than the film can represent.
scene::Scene tooBright() {
  return sceneFromText(
      "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\n"
      "f 0 0 0 1 0 0 0 0 1 0 1 1e7 1 1\ns 0 0 0 1\n");
}

// Balls under a point light that is nearly as bright as single precision permits: pi times its colour is infinite, and
// the green of a red ball is 0 times that.
scene::Scene overflowing() {
  return sceneFromText(
      "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\n"
      "l 0 10 9 1.1e38 1.1e38 1.1e38\n"
      "f 1 0 0 1 0 0 0 0 1 0 1\ns -1 0 0 1.2\n"
      "f .9 .9 .9 1 0 0 0 0 1 0 1\ns 1 0 0 1.2\n");
}

void requireEqualCounts(const image::Film& device, const image::Film& reference) {
  for (std::size_t i = 0; i < device.pixels().size(); ++i) {
    INFO("pixel " << i);
    REQUIRE(device.pixels()[i].badCount == reference.pixels()[i].badCount);
    REQUIRE(device.pixels()[i].firstBadSample == reference.pixels()[i].firstBadSample);
  }
}

}  // namespace

TEST_CASE("samples beyond the film's range are clamped and counted by both tracers") {
  const scene::Scene scene = tooBright();
  const render::RenderSettings settings = squareSettings(8, 4);
  const render::RenderResult device = renderOnDevice(scene, settings);
  const render::RenderResult reference = renderOnReference(scene, settings);
  for (const auto& result : {device, reference}) {
    const image::FilmPixel& middle = result.film.at(4, 4);
    CHECK(middle.badCount == 4);
    CHECK(middle.firstBadSample == 1);
    CHECK(result.film.mean(4, 4).x == image::kFilmMaximum);
    CHECK(result.film.at(0, 0).badCount == 0);
    CHECK(result.statistics.badSamples > 0);
  }
  requireEqualCounts(device.film, reference.film);
}

TEST_CASE("radiance that overflows only on a device is counted as a bad sample by both tracers") {
  const scene::Scene scene = overflowing();
  const render::RenderSettings settings = squareSettings(8, 4);
  const render::RenderResult device = renderOnDevice(scene, settings);
  const render::RenderResult reference = renderOnReference(scene, settings);
  requireEqualCounts(device.film, reference.film);
  CHECK(device.statistics.badSamples == reference.statistics.badSamples);
  // In these pixels every sample overflows: on the device it is infinite, which adds 0; on the reference it is too
  // bright.
  std::size_t overflowed = 0;
  for (std::size_t i = 0; i < device.film.pixels().size(); ++i) {
    const auto x = static_cast<std::uint32_t>(i % 8), y = static_cast<std::uint32_t>(i / 8);
    if (device.film.at(x, y).badCount < 4 || device.film.mean(x, y).x != 0) continue;
    ++overflowed;
    CHECK(reference.film.mean(x, y).x == image::kFilmMaximum);
  }
  CHECK(overflowed > 0);
  for (const image::FilmPixel& pixel : device.film.pixels()) REQUIRE(pixel.sampleCount == 4);
}
