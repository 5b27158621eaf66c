// Colours of tiles.
#include "host/judge/report/tile_map.h"

#include <catch2/catch.hpp>

namespace candela::report {
namespace {

using verify::Region;
using verify::RegionResult;

// A tile of 8 pixels at x = 8 column, y = 0, whose t is this multiple of the critical t.
RegionResult tile(std::uint32_t column, double difference, double timesCritical) {
  RegionResult result;
  result.region = {8 * column, 0, 8, 8, 8, Region::Quantity::luminance};
  result.test.difference = difference;
  result.test.standardError = 1;
  result.test.degreesOfFreedom = 62;
  result.test.t = timesCritical * statistics::criticalT(1e-6, 62);
  result.differs = timesCritical > 1;
  return result;
}

glm::ivec3 pixelOf(const image::Pixels8& pixels, std::uint32_t x, std::uint32_t y) {
  const std::uint8_t* first = &pixels.rgb[3 * (std::size_t{y} * pixels.width + x)];
  return {first[0], first[1], first[2]};
}

TEST_CASE("tiles are orange if A is brighter and blue if it is darker, by their t, and framed if they differ") {
  const std::vector<RegionResult> results{tile(0, 1, 0), tile(1, 1, 0.5), tile(2, -1, 0.5), tile(3, -1, 2)};
  const image::Pixels8 map = tileMap(results, 8, 1e-6, 32, 8);
  CHECK(pixelOf(map, 4, 4) == glm::ivec3(0));
  CHECK(pixelOf(map, 12, 4) == glm::ivec3(128, 70, 13));
  CHECK(pixelOf(map, 8, 0) == glm::ivec3(128, 70, 13));
  CHECK(pixelOf(map, 20, 4) == glm::ivec3(19, 64, 128));
  CHECK(pixelOf(map, 28, 4) == glm::ivec3(38, 128, 255));
  CHECK(pixelOf(map, 24, 0) == glm::ivec3(255));
}

TEST_CASE("a difference of tiles without noise has full colour") {
  RegionResult result = tile(0, 1, 0);
  result.test.standardError = 0;
  CHECK(pixelOf(tileMap(std::vector{result}, 8, 1e-6, 8, 8), 4, 4) == glm::ivec3(0));
  result.differs = true;
  CHECK(pixelOf(tileMap(std::vector{result}, 8, 1e-6, 8, 8), 4, 4) == glm::ivec3(255, 140, 26));
}

TEST_CASE("the list of tile sizes omits the whole image") {
  RegionResult image = tile(0, 0, 0);
  image.region.tileSize = 0;
  RegionResult large = tile(0, 0, 0);
  large.region.tileSize = 32;
  CHECK(tileSizes(std::vector{image, large, tile(0, 0, 0), tile(1, 0, 0)}) == std::vector<std::uint32_t>{8, 32});
}

}  // namespace
}  // namespace candela::report
