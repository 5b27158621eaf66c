// Implements docs/denoising.md, section 3, pixel by pixel.
#include "host/trace/denoise/reference_filter.h"

#include <algorithm>

#include "host/trace/denoise/similarity.h"

namespace candela::denoise {
namespace {

using glm::dvec3;
using gpu::DenoisePixel;

struct Position {
  int x, y;
};

Position operator+(const Position& a, const Position& b) { return {a.x + b.x, a.y + b.y}; }

/// Returns the offsets in a square around the origin.
std::vector<Position> square(int radius) {
  std::vector<Position> positions;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) positions.push_back({x, y});
  }
  return positions;
}

class ReferenceFilter {
 public:
  explicit ReferenceFilter(const PixelStatistics& statistics)
      : statistics_(statistics), window_(square(gpu::kDenoiseRadius)), patch_(square(gpu::kDenoisePatchRadius)) {}

  dvec3 at(const Position& position) const {
    const dvec3 own(pixel(position).light);
    if (!isFiltered(position)) return own;
    dvec3 sum(0);
    double weights = 0;
    for (const Position& offset : window_) {
      if (!isFiltered(position + offset)) continue;
      const double weight = weightOf(position, position + offset);
      sum += weight * (dvec3(pixel(position + offset).light) - own);
      weights += weight;
    }
    return own + sum / weights;
  }

 private:
  bool isFiltered(const Position& position) const { return contains(position) && pixel(position).light.w > 0; }
  bool contains(const Position& position) const {
    return position.x >= 0 && position.y >= 0 && position.x < static_cast<int>(statistics_.width) &&
           position.y < static_cast<int>(statistics_.height);
  }
  const DenoisePixel& pixel(const Position& position) const {
    return statistics_
        .pixels[static_cast<std::size_t>(position.y) * statistics_.width + static_cast<std::size_t>(position.x)];
  }

  double weightOf(const Position& a, const Position& b) const {
    const double guides = guideWeight(pixel(a), pixel(b));
    return guides > 0 ? guides * closeness(a, b) * membershipOf(a, b) * pixel(b).light.w : 0;
  }

  static double closeness(const Position& a, const Position& b) {
    constexpr double kEnd = gpu::kDenoiseRadius + 1;
    const double x = a.x - b.x, y = a.y - b.y;
    return std::max(0.0, 1 - (x * x + y * y) / (kEnd * kEnd));
  }

  double membershipOf(const Position& a, const Position& b) const {
    const double ofPixels = compareMeans(pixel(a).root, pixel(b).root).quotient() / kPixelTolerance;
    return membership(std::max(ofPatches(a, b).quotient(), ofPixels));
  }

  WelchStatistic ofPatches(const Position& a, const Position& b) const {
    WelchStatistic sum;
    for (const Position& offset : patch_) {
      if (!isFiltered(a + offset) || !isFiltered(b + offset)) continue;
      const WelchStatistic term = compareMeans(pixel(a + offset).root, pixel(b + offset).root);
      sum.squaredDifference += term.squaredDifference;
      sum.variance += term.variance;
    }
    return sum;
  }

  const PixelStatistics& statistics_;
  std::vector<Position> window_, patch_;
};

}  // namespace

std::vector<glm::vec3> filterByReference(const PixelStatistics& statistics) {
  const ReferenceFilter filter(statistics);
  std::vector<glm::vec3> light;
  light.reserve(statistics.pixels.size());
  for (int y = 0; y < static_cast<int>(statistics.height); ++y) {
    for (int x = 0; x < static_cast<int>(statistics.width); ++x) light.emplace_back(filter.at({x, y}));
  }
  return light;
}

}  // namespace candela::denoise
