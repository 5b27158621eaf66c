// Compares each pixel with the mean of its neighbours.
#include "host/trace/denoise/isolated_samples.h"

#include <algorithm>
#include <cmath>

#include "host/trace/denoise/similarity.h"

namespace candela::denoise {
namespace {

using glm::dvec3, glm::dvec4;
using gpu::DenoisePixel;

constexpr int kRadius = 3;
constexpr double kMaxRatio = 8;        // of the light of a pixel and of the mean of its neighbours
constexpr double kReliableWeight = 4;  // of the neighbours together; fewer limit a pixel less

double sumOf(const dvec3& v) { return v.x + v.y + v.z; }

/// Weighted means over the neighbours of a pixel.
class Neighbours {
 public:
  void add(const DenoisePixel& neighbour, double similarity) {
    const double weight = similarity * neighbour.light.w;
    similarity_ += similarity;
    weight_ += weight;
    light_ += weight * sumOf(neighbour.light);
    root_ += weight * dvec3(neighbour.root);
    rootVariance_ += weight * weight * neighbour.root.w;
  }

  bool isEmpty() const { return weight_ <= 0; }
  double reliability() const { return std::min(1.0, similarity_ / kReliableWeight); }
  double light() const { return light_ / weight_; }
  dvec4 root() const { return {root_ / weight_, rootVariance_ / (weight_ * weight_)}; }

 private:
  double similarity_ = 0, weight_ = 0, light_ = 0, rootVariance_ = 0;
  dvec3 root_{0};
};

class Limiter {
 public:
  explicit Limiter(const PixelStatistics& statistics)
      : pixels_(statistics.pixels),
        width_(static_cast<int>(statistics.width)),
        height_(static_cast<int>(statistics.height)) {}

  /// Returns the factor f of every pixel; 1 for those that are not filtered.
  std::vector<float> factors() const {
    std::vector<float> factors;
    factors.reserve(pixels_.size());
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) factors.push_back(static_cast<float>(at(x, y).light.w > 0 ? factorAt(x, y) : 1));
    }
    return factors;
  }

 private:
  double factorAt(int x, int y) const {
    const DenoisePixel& own = at(x, y);
    const Neighbours neighbours = neighboursOf(x, y);
    if (neighbours.isEmpty()) return 1;
    const double excess = 1 - kMaxRatio * neighbours.light() / sumOf(own.light);
    if (!(excess > 0)) return 1;
    const double statistic = compareMeans(own.root, neighbours.root()).quotient() / kPixelTolerance;
    return 1 - excess * membership(statistic) * neighbours.reliability();
  }

  const DenoisePixel& at(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }

  Neighbours neighboursOf(int x, int y) const {
    Neighbours neighbours;
    for (int v = std::max(0, y - kRadius); v <= std::min(height_ - 1, y + kRadius); ++v) {
      for (int u = std::max(0, x - kRadius); u <= std::min(width_ - 1, x + kRadius); ++u) {
        if ((u != x || v != y) && at(u, v).light.w > 0) neighbours.add(at(u, v), guideWeight(at(x, y), at(u, v)));
      }
    }
    return neighbours;
  }

  const std::vector<DenoisePixel>& pixels_;
  int width_, height_;
};

double luminanceOf(const DenoisePixel& pixel) {
  return double{image::luminance(glm::vec3(pixel.light) * divisorOf(pixel.reflectance))};
}

void scale(DenoisePixel& pixel, float factor) {
  pixel.light = glm::vec4(glm::vec3(pixel.light) * factor, pixel.light.w);
  pixel.root = glm::vec4(glm::vec3(pixel.root) * std::sqrt(factor), pixel.root.w * factor);
}

}  // namespace

LimitedLight limitIsolatedSamples(PixelStatistics& statistics) {
  const std::vector<float> factors = Limiter(statistics).factors();
  LimitedLight limited;
  double before = 0, after = 0;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    DenoisePixel& pixel = statistics.pixels[i];
    before += luminanceOf(pixel);
    if (factors[i] < 1) {
      scale(pixel, factors[i]);
      ++limited.pixelCount;
    }
    after += luminanceOf(pixel);
  }
  if (before > 0) limited.removedFraction = 1 - after / before;
  return limited;
}

}  // namespace candela::denoise
