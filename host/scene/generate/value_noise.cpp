// Value noise on a lattice of hashed integers.
#include "host/scene/generate/value_noise.h"

#include <algorithm>
#include <cmath>

#include "host/scene/generate/hash_sequence.h"

namespace candela::generate {
namespace {

/// Returns a uniform value in [0, 1).
double latticeValue(const glm::ivec3& point, std::uint32_t seed) {
  constexpr std::uint32_t kNotZero = 0x9e3779b9u;  // 0 is a fixed point of the permutation
  std::uint32_t hash = mixedBits(seed + kNotZero);
  for (int axis = 0; axis < 3; ++axis) hash = mixedBits(hash ^ static_cast<std::uint32_t>(point[axis]));
  return hash * 0x1p-32;
}

}  // namespace

double valueNoise(const glm::dvec3& point, std::uint32_t seed) {
  const glm::dvec3 floor = glm::floor(point);
  const glm::dvec3 fraction = point - floor;
  const glm::dvec3 weight = fraction * fraction * (3.0 - 2.0 * fraction);
  const glm::ivec3 cell(floor);
  const auto along = [&](int y, int z) {
    return glm::mix(latticeValue(cell + glm::ivec3(0, y, z), seed), latticeValue(cell + glm::ivec3(1, y, z), seed),
                    weight.x);
  };
  return glm::mix(glm::mix(along(0, 0), along(1, 0), weight.y), glm::mix(along(0, 1), along(1, 1), weight.y), weight.z);
}

double fractalNoise(const glm::dvec3& point, std::uint32_t octaves) {
  double sum = 0;
  double total = 0;
  for (std::uint32_t octave = 0; octave < octaves; ++octave) {
    const double frequency = std::exp2(octave);
    sum += valueNoise(point * frequency, octave) / frequency;
    total += 1 / frequency;
  }
  return sum / total;
}

double smoothStep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace candela::generate
