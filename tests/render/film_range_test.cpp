// Samples that the film cannot hold are counted where they fall, on both sides.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/render/render_support.h"

using namespace candela;

namespace {

// A lamp brighter than the film can hold.
Scene tooBright() {
  return sceneFromText(
      "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\n"
      "f 0 0 0 1 0 0 0 0 1 0 1 1e7 1 1\ns 0 0 0 1\n");
}

// Balls under a large lamp that nearly is the brightest a number can say: in single precision what a surface gets of it
// is infinite, and where a red ball gets it from a white one, green is 0 times infinity.
Scene overflowing() {
  return sceneFromText(
      "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\n"
      "f 0 0 0 1 0 0 0 0 1 0 1 3e38 3e38 3e38\ns 0 40 0 30\n"
      "f 1 0 0 1 0 0 0 0 1 0 1\ns -1 0 0 1.2\n"
      "f .9 .9 .9 1 0 0 0 0 1 0 1\ns 1 0 0 1.2\n");
}

void requireEqualCounts(const Film& device, const Film& reference) {
  for (std::size_t i = 0; i < device.pixels().size(); ++i) {
    INFO("pixel " << i);
    REQUIRE(device.pixels()[i].badCount == reference.pixels()[i].badCount);
    REQUIRE(device.pixels()[i].firstBadSample == reference.pixels()[i].firstBadSample);
  }
}

}  // namespace

TEST_CASE("samples beyond the film's range are clamped and counted on both tracers") {
  const Scene scene = tooBright();
  const RenderSettings settings = squareSettings(8, 4);
  const RenderResult device = renderOnDevice(scene, settings);
  const RenderResult reference = renderOnReference(scene, settings);
  for (const auto& result : {device, reference}) {
    const FilmPixel& middle = result.film.at(4, 4);
    CHECK(middle.badCount == 4);
    CHECK(middle.firstBadSample == 1);
    CHECK(result.film.mean(4, 4).x == kFilmMaximum);
    CHECK(result.film.at(0, 0).badCount == 0);
    CHECK(result.statistics.badSamples > 0);
  }
  requireEqualCounts(device.film, reference.film);
}

TEST_CASE("what overflows on a device is counted there as on the reference, which has the range to hold it") {
  const Scene scene = overflowing();
  const RenderSettings settings = squareSettings(8, 4);
  const RenderResult device = renderOnDevice(scene, settings);
  const RenderResult reference = renderOnReference(scene, settings);
  requireEqualCounts(device.film, reference.film);
  CHECK(device.statistics.badSamples == reference.statistics.badSamples);
  // The top of the white ball: infinite there, too bright here.
  const std::uint32_t x = 5, y = 3;
  CHECK(device.film.at(x, y).badCount == 4);
  CHECK(device.film.mean(x, y) == glm::dvec3(0));
  CHECK(reference.film.mean(x, y) == glm::dvec3(kFilmMaximum));
  for (const FilmPixel& pixel : device.film.pixels()) REQUIRE(pixel.sampleCount == 4);
}
