// Implements docs/denoising.md, section 3, pixel by pixel.
#include "host/denoise/reference_filter.h"

#include <algorithm>

namespace candela::denoise {
namespace {

using glm::dvec3;
using gpu::DenoisePixel;

constexpr double kFullMembership = 0.3, kNoMembership = 1.5;
constexpr double kPixelTolerance = 4;
constexpr double kNormalWidth = 0.3, kReflectanceWidth = 0.5, kGuideNoise = 2;
constexpr double kSmallestVariance = 1e-10;

struct Place {
  int x, y;
};

Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y}; }

/// Returns the offsets in a square around the origin.
std::vector<Place> square(int radius) {
  std::vector<Place> places;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) places.push_back({x, y});
  }
  return places;
}

class ReferenceFilter {
 public:
  explicit ReferenceFilter(const PixelStatistics& statistics)
      : statistics_(statistics), window_(square(gpu::kDenoiseRadius)), patch_(square(gpu::kDenoisePatchRadius)) {}

  dvec3 at(const Place& place) const {
    const dvec3 own(pixel(place).light);
    if (!isFiltered(place)) return own;
    dvec3 sum(0);
    double weights = 0;
    for (const Place& offset : window_) {
      if (!isFiltered(place + offset)) continue;
      const double weight = weightOf(place, place + offset);
      sum += weight * (dvec3(pixel(place + offset).light) - own);
      weights += weight;
    }
    return own + sum / weights;
  }

 private:
  bool isFiltered(const Place& place) const { return contains(place) && pixel(place).light.w > 0; }
  bool contains(const Place& place) const {
    return place.x >= 0 && place.y >= 0 && place.x < static_cast<int>(statistics_.width) &&
           place.y < static_cast<int>(statistics_.height);
  }
  const DenoisePixel& pixel(const Place& place) const {
    return statistics_
        .pixels[static_cast<std::size_t>(place.y) * statistics_.width + static_cast<std::size_t>(place.x)];
  }

  double weightOf(const Place& a, const Place& b) const {
    const double guides = guide(pixel(a).normal, pixel(b).normal, kNormalWidth) *
                          guide(pixel(a).reflectance, pixel(b).reflectance, kReflectanceWidth);
    return guides > 0 ? guides * closeness(a, b) * membership(a, b) * pixel(b).light.w : 0;
  }

  static double closeness(const Place& a, const Place& b) {
    constexpr double kEnd = gpu::kDenoiseRadius + 1;
    const double x = a.x - b.x, y = a.y - b.y;
    return std::max(0.0, 1 - (x * x + y * y) / (kEnd * kEnd));
  }

  static double guide(const glm::vec4& a, const glm::vec4& b, double width) {
    const dvec3 difference = dvec3(a) - dvec3(b);
    const double excess = dot(difference, difference) - kGuideNoise * (double{a.w} + b.w);
    return std::max(0.0, 1 - std::max(0.0, excess) / (width * width));
  }

  double membership(const Place& a, const Place& b) const {
    const double statistic = std::max(ofPatches(a, b), ofPixels(a, b).quotient() / kPixelTolerance);
    return std::clamp((kNoMembership - statistic) / (kNoMembership - kFullMembership), 0.0, 1.0);
  }

  /// The square of Welch's statistic before the division.
  struct Statistic {
    double squaredDifference = 0, variance = 0;

    double quotient() const { return squaredDifference / variance; }
  };

  Statistic ofPixels(const Place& a, const Place& b) const {
    const dvec3 difference = dvec3(pixel(a).root) - dvec3(pixel(b).root);
    return {dot(difference, difference), double{pixel(a).root.w} + pixel(b).root.w + kSmallestVariance};
  }

  double ofPatches(const Place& a, const Place& b) const {
    Statistic sum;
    for (const Place& offset : patch_) {
      if (!isFiltered(a + offset) || !isFiltered(b + offset)) continue;
      const Statistic term = ofPixels(a + offset, b + offset);
      sum.squaredDifference += term.squaredDifference;
      sum.variance += term.variance;
    }
    return sum.quotient();
  }

  const PixelStatistics& statistics_;
  std::vector<Place> window_, patch_;
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
