// Samples that the film cannot hold are counted where they fall, on both sides.
#include <catch2/catch.hpp>

#include "tests/render/render_support.h"

using namespace candela;

TEST_CASE("samples beyond the film's range are clamped and counted on both tracers") {
  const Scene scene = sceneFromText(
      "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\n"
      "f 0 0 0 1 0 0 0 0 1 0 1 1e7 1 1\ns 0 0 0 1\n");
  const RenderSettings settings = squareSettings(8, 4);
  for (const auto& result : {renderOnDevice(scene, settings), renderOnReference(scene, settings)}) {
    const FilmPixel& middle = result.film.at(4, 4);
    CHECK(middle.badCount == 4);
    CHECK(middle.firstBadSample == 1);
    CHECK(result.film.mean(4, 4).x == kFilmMaximum);
    CHECK(result.film.at(0, 0).badCount == 0);
    CHECK(result.statistics.badSamples > 0);
  }
}
