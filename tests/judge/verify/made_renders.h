// Renders whose expected picture and noise are known: samples with light or heavy tails, which a reconstruction filter
// distributes to several pixels.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "host/image/image.h"

namespace candela::verify {

/// The distribution of a sample, of mean 1. exponential: as skewed as radiance of direct light is; fireflies: the same,
/// and one sample in 1000 is 300 brighter; pareto: P(X > x) falls as x^-1.5, so that the variance is infinite.
enum class Tail : std::uint8_t { exponential, fireflies, pareto };

struct MadeOptions {
  std::uint32_t side = 32;
  std::uint32_t samples = 2;         ///< per pixel
  std::uint32_t samplesOnRight = 0;  ///< per pixel of the right half; 0: `samples`
  Tail tail = Tail::exponential;
  bool isSplatted = false;  ///< a Gaussian filter of standard deviation 0.5 and radius 2 pixels, else a box
  double factor = 1;        ///< of all pixels
};

class MadeRender {
 public:
  MadeRender(std::uint32_t seed, const MadeOptions& options)
      : options_(options),
        random_(seed),
        sums_(std::size_t{options.side} * options.side),
        squares_(std::size_t{options.side} * options.side),
        weights_(std::size_t{options.side} * options.side) {
    for (std::uint32_t y = 0; y < options.side; ++y) {
      for (std::uint32_t x = 0; x < options.side; ++x) {
        for (std::uint32_t i = 0; i < samplesAt(x); ++i) addSample(x, y);
      }
    }
  }

  /// Returns the picture with the variances of one sample, from moments that are filtered as the colours are.
  image::Image imageWithVariances() const {
    image::Image image = this->image();
    const double scale = options_.factor * image::luminance(kColour);
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const double mean = sums_[i] / weights_[i];
      image.luminanceVariance.push_back(
          static_cast<float>(scale * scale * std::max(0.0, squares_[i] / weights_[i] - mean * mean)));
    }
    image.sampleCounts.assign(sums_.size(), options_.samples);
    return image;
  }

  image::Image image() const {
    image::Image image;
    image.width = image.height = options_.side;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      image.rgb.push_back(glm::vec3(options_.factor * sums_[i] / weights_[i] * kColour));
    }
    return image;
  }

 private:
  std::uint32_t samplesAt(std::uint32_t x) const {
    return options_.samplesOnRight > 0 && x >= options_.side / 2 ? options_.samplesOnRight : options_.samples;
  }

  double noise() {
    switch (options_.tail) {
      case Tail::pareto:
        return std::pow(1 - uniform_(random_), -1 / 1.5) / 3;
      case Tail::fireflies:
        return (exponential_(random_) + (uniform_(random_) < 1e-3 ? 300 : 0)) / 1.3;
      case Tail::exponential:
        break;
    }
    return exponential_(random_);
  }

  // The light falls from left to right, to a sixth.
  void addSample(std::uint32_t x, std::uint32_t y) {
    const double value = noise() * (1.2 - double{1} * x / options_.side);
    if (!options_.isSplatted) return add(x, y, 1, value);
    const double u = x + uniform_(random_), v = y + uniform_(random_);
    const auto across = weightsAt(u), down = weightsAt(v);
    const auto left = static_cast<std::int64_t>(std::floor(u - 0.5)) - 1;
    const auto top = static_cast<std::int64_t>(std::floor(v - 0.5)) - 1;
    for (std::size_t j = 0; j < kTaps; ++j) {
      for (std::size_t i = 0; i < kTaps; ++i) {
        const std::int64_t column = left + static_cast<std::int64_t>(i), row = top + static_cast<std::int64_t>(j);
        if (column < 0 || row < 0 || column >= options_.side || row >= options_.side) continue;
        add(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), across[i] * down[j], value);
      }
    }
  }

  static constexpr glm::dvec3 kColour{1, 0.8, 0.6};
  static constexpr std::size_t kTaps = 4;
  using Weights = std::array<double, kTaps>;

  // Returns the weights of the four pixels whose centres are nearest.
  static Weights weightsAt(double position) {
    Weights weights{};
    for (std::size_t i = 0; i < kTaps; ++i) {
      const double distance = std::floor(position - 0.5) - 0.5 + static_cast<double>(i) - position;
      weights[i] = std::exp(-2 * distance * distance);
    }
    return weights;
  }

  void add(std::uint32_t x, std::uint32_t y, double weight, double value) {
    sums_[std::size_t{y} * options_.side + x] += weight * value;
    squares_[std::size_t{y} * options_.side + x] += weight * value * value;
    weights_[std::size_t{y} * options_.side + x] += weight;
  }

  MadeOptions options_;
  std::mt19937 random_;
  std::uniform_real_distribution<double> uniform_;
  std::exponential_distribution<double> exponential_;
  std::vector<double> sums_, squares_, weights_;
};

}  // namespace candela::verify
