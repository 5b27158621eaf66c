// Chooses texels, and converts between directions and coordinates of the map.
#include "host/trace/reference/environment_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/base/hypotenuse.h"

namespace candela::reference {

namespace {

std::vector<std::uint64_t> rowSums(const scene::Environment& environment) {
  std::vector<std::uint64_t> sums(environment.height);
  for (std::size_t i = 0; i < environment.weights.size(); ++i) sums[i / environment.width] += environment.weights[i];
  return sums;
}

}  // namespace

Partition::Partition(std::span<const std::uint64_t> weights) {
  std::vector<double> sums;
  std::uint64_t sum = 0;
  for (const std::uint64_t weight : weights) sums.push_back(static_cast<double>(sum += weight));
  for (std::size_t i = 0; i + 1 < weights.size(); ++i) {
    const double end = sum > 0 ? std::floor(std::ldexp(sums[i] / sums.back(), 32)) : 0;
    ends_.push_back(static_cast<std::uint32_t>(std::min(end, 0xffffffffp0)));
  }
}

std::uint32_t Partition::choose(std::uint32_t number) const {
  return static_cast<std::uint32_t>(std::ranges::upper_bound(ends_, number) - ends_.begin());
}

double Partition::probability(std::uint32_t interval) const {
  const double begin = interval == 0 ? 0 : ends_[interval - 1];
  const double end = interval == ends_.size() ? 0x1p32 : ends_[interval];
  return (end - begin) / 0x1p32;
}

EnvironmentMap::EnvironmentMap(const scene::Environment& environment)
    : environment_(environment),
      rows_(rowSums(environment)),
      toScene_(environment.axes[0], environment.axes[1], environment.axes[2]),
      shines_(std::ranges::any_of(environment.weights, [](std::uint64_t weight) { return weight > 0; })) {
  const std::span<const std::uint64_t> weights(environment.weights);
  for (std::size_t i = 0; i < weights.size(); i += environment.width) {
    columns_.emplace_back(weights.subspan(i, environment.width));
  }
}

double EnvironmentMap::pdf(std::uint32_t texel, double sine) const {
  const std::uint32_t row = texel / environment_.width;
  const double chosen = rows_.probability(row) * columns_[row].probability(texel % environment_.width);
  const bool isFolded = environment_.hasRowsAtPoles && (row == 0 || row + 1 == environment_.height);
  const double across = environment_.width * (isFolded ? 2.0 : 1.0);
  return chosen > 0 ? chosen * across * rowsBetweenPoles() / (2 * kPi * kPi * sine) : 0;
}

EnvironmentMap::Tap EnvironmentMap::tap(const dvec3& direction, const dvec2& jitter) const {
  const dvec3 d = direction * toScene_;
  const double width = environment_.width;
  const double height = environment_.height;
  const double sine = hypotenuse(d.x, d.z);
  double s = width * (0.5 + std::atan2(d.z, d.x) / (2 * kPi)) + jitter.x - 0.5;
  double t = environment_.offsetOfPoles() + rowsBetweenPoles() * std::atan2(sine, d.y) / kPi + jitter.y - 0.5;
  if (t < 0 || t > height) {
    s += width / 2;
    t = t < 0 ? -t : 2 * height - t;
  }
  s -= width * std::floor(s / width);
  const auto column = std::min(static_cast<std::uint32_t>(s), environment_.width - 1);
  const auto row = std::min(static_cast<std::uint32_t>(t), environment_.height - 1);
  const std::uint32_t texel = row * environment_.width + column;
  return {texel, environment_.texels[texel], pdf(texel, sine)};
}

std::optional<LightSample> EnvironmentMap::sample(const glm::uvec2& words, const dvec2& point) const {
  const std::uint32_t row = rows_.choose(words.x);
  const std::uint32_t column = columns_[row].choose(words.y);
  const std::uint32_t texel = row * environment_.width + column;
  const double s = column + 0.5 + sampleTent(point.x);
  const double t = row + 0.5 + sampleTent(point.y);
  const double azimuth = kPi * (2 * s / environment_.width - 1);
  const double polar = kPi * (t - environment_.offsetOfPoles()) / rowsBetweenPoles();
  double sine = std::sin(polar);  // negative beyond the poles, where the azimuth is the opposite one
  if (environment_.hasRowsAtPoles) sine = std::abs(sine);
  if (sine == 0) return std::nullopt;
  const dvec3 d(sine * std::cos(azimuth), std::cos(polar), sine * std::sin(azimuth));
  constexpr double kFar = std::numeric_limits<float>::max();
  return LightSample{toScene_ * d, kFar, environment_.texels[texel], pdf(texel, std::abs(sine)), kNoPrimitive};
}

}  // namespace candela::reference
