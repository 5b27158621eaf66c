// Builds the alias table, and converts between directions and coordinates of the map.
#include "host/reference/environment_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela::reference {

AliasTable::AliasTable(const std::vector<std::uint64_t>& weights, std::uint64_t mean) : bins_(weights.size()) {
  const auto size = static_cast<std::uint32_t>(weights.size());
  const auto next = [&](std::uint32_t from, bool heavy) {
    while (from < size && (weights[from] > mean) != heavy) ++from;
    return from;
  };
  for (std::uint32_t i = 0; i < size; ++i) bins_[i] = {static_cast<std::uint32_t>(mean), i};
  std::uint32_t light = next(0, false);
  std::uint32_t heavy = next(0, true);
  std::uint64_t rest = heavy < size ? weights[heavy] : 0;
  while (heavy < size) {
    if (rest > mean) {
      bins_[light] = {static_cast<std::uint32_t>(weights[light]), heavy};
      rest -= mean - weights[light];
      light = next(light + 1, false);
      continue;
    }
    const std::uint32_t following = next(heavy + 1, true);
    if (following < size) {
      bins_[heavy] = {static_cast<std::uint32_t>(rest), following};
      rest += weights[following] - mean;
    }
    heavy = following;
  }
}

std::uint32_t AliasTable::choose(std::uint64_t number) const {
  // The product of `number` with the number of bins, without its lowest 32 bits.
  const std::uint64_t size = bins_.size();
  const std::uint64_t product = (number >> 32) * size + ((number & 0xffffffffu) * size >> 32);
  const Bin& bin = bins_[product >> 32];
  const auto k = static_cast<std::uint32_t>(product) >> 8;
  return k < bin.threshold ? static_cast<std::uint32_t>(product >> 32) : bin.alias;
}

EnvironmentMap::EnvironmentMap(const scene::Environment& environment)
    : environment_(environment),
      table_(environment.weights, scene::Environment::kMeanWeight),
      toScene_(environment.axes[0], environment.axes[1], environment.axes[2]),
      shines_(std::ranges::any_of(environment.weights, [](std::uint64_t weight) { return weight > 0; })) {}

double EnvironmentMap::pdf(std::uint32_t texel, double sine) const {
  const double relative = static_cast<double>(environment_.weights[texel]) / scene::Environment::kMeanWeight;
  return relative > 0 ? relative / (2 * kPi * kPi * sine) : 0;
}

EnvironmentMap::Tap EnvironmentMap::tap(const dvec3& direction, const dvec2& jitter) const {
  const dvec3 d = direction * toScene_;
  const double width = environment_.width;
  const double height = environment_.height;
  const double sine = std::hypot(d.x, d.z);
  double s = width * (0.5 + std::atan2(d.z, d.x) / (2 * kPi)) + jitter.x - 0.5;
  double t = height * std::atan2(sine, d.y) / kPi + jitter.y - 0.5;
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

std::optional<LightSample> EnvironmentMap::sample(std::uint64_t choice, const dvec2& point) const {
  const std::uint32_t texel = table_.choose(choice);
  const double s = texel % environment_.width + 0.5 + sampleTent(point.x);
  const double t = texel / environment_.width + 0.5 + sampleTent(point.y);
  const double azimuth = kPi * (2 * s / environment_.width - 1);
  const double polar = kPi * t / environment_.height;  // beyond the poles, the azimuth is the opposite one
  const double sine = std::sin(polar);
  if (sine == 0) return std::nullopt;
  const dvec3 d(sine * std::cos(azimuth), std::cos(polar), sine * std::sin(azimuth));
  constexpr double kFar = std::numeric_limits<float>::max();
  return LightSample{toScene_ * d, kFar, environment_.texels[texel], pdf(texel, std::abs(sine)), kNoPrimitive};
}

}  // namespace candela::reference
