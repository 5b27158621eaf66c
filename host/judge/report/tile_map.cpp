// Draws maps of the tests of tiles.
#include "host/judge/report/tile_map.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "host/image/colour_map.h"

namespace candela::report {
namespace {

using verify::Region;
using verify::RegionResult;

// Returns |t| as a fraction of the critical t, with the sign of the difference.
double strengthOf(const RegionResult& result, double level) {
  const double sign = result.test.difference < 0 ? -1 : 1;
  if (result.differs) return sign;
  if (result.test.standardError == 0) return 0;
  return sign * std::min(1.0, result.test.t / statistics::criticalT(level, result.test.degreesOfFreedom));
}

void paint(image::Pixels8& map, std::uint32_t x, std::uint32_t y, const glm::dvec3& signal) {
  for (int c = 0; c < 3; ++c) {
    map.rgb[3 * (std::size_t{y} * map.width + x) + static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(
        std::lround(255 * signal[c]));
  }
}

void paintTile(image::Pixels8& map, const RegionResult& result, double level) {
  const Region& tile = result.region;
  const glm::dvec3 colour = image::signedColour(strengthOf(result, level));
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    for (std::uint32_t x = 0; x < tile.width; ++x) {
      const bool onEdge = x == 0 || y == 0 || x + 1 == tile.width || y + 1 == tile.height;
      paint(map, tile.x + x, tile.y + y, result.differs && onEdge ? glm::dvec3(1) : colour);
    }
  }
}

}  // namespace

std::vector<std::uint32_t> tileSizes(std::span<const RegionResult> results) {
  std::set<std::uint32_t> sizes;
  for (const RegionResult& result : results) {
    if (result.region.tileSize > 0) sizes.insert(result.region.tileSize);
  }
  return {sizes.begin(), sizes.end()};
}

image::Pixels8 tileMap(std::span<const RegionResult> results, std::uint32_t tileSize, double level, std::uint32_t width,
                       std::uint32_t height) {
  image::Pixels8 map{width, height, std::vector<std::uint8_t>(std::size_t{3} * width * height)};
  for (const RegionResult& result : results) {
    if (result.region.tileSize == tileSize) paintTile(map, result, level);
  }
  return map;
}

}  // namespace candela::report
