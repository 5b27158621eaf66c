// The environment: taps of its map, and their choice by two numbers (docs/light-transport.md section 6).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/scene/environment.h"
#include "host/trace/reference/light.h"
#include "host/trace/reference/sampling.h"

namespace candela::reference {

/// Divides the words of 32 bits into intervals in proportion to integer weights.
class Partition {
 public:
  /// The sum of the weights is at most 2^53.
  explicit Partition(std::span<const std::uint64_t> weights);

  /// Returns the interval that has `number`.
  std::uint32_t choose(std::uint32_t number) const;
  /// Returns the exact probability with which a uniform number chooses an interval.
  double probability(std::uint32_t interval) const;

 private:
  std::vector<std::uint32_t> ends_;  ///< without the last one, which is 2^32
};

class EnvironmentMap {
 public:
  /// A texel of the map that is used as the radiance in a direction.
  struct Tap {
    std::uint32_t texel;
    dvec3 radiance;
    double pdf;  ///< with which sample() chooses direction and tap, per solid angle, apart from their common factor
  };

  /// `environment` must outlive the object.
  explicit EnvironmentMap(const scene::Environment& environment);

  /// Returns whether any texel shines.
  bool shines() const { return shines_; }
  /// `jitter` is uniform in the unit square. The direction is a unit vector of the scene.
  Tap tap(const dvec3& direction, const dvec2& jitter) const;
  /// Returns a sample, farther away than any surface. `words` are uniform, and `point` is uniform in the unit square.
  std::optional<LightSample> sample(const glm::uvec2& words, const dvec2& point) const;

 private:
  double pdf(std::uint32_t texel, double sine) const;
  double rowsBetweenPoles() const { return environment_.height - 2 * environment_.offsetOfPoles(); }

  const scene::Environment& environment_;
  Partition rows_;
  std::vector<Partition> columns_;
  glm::dmat3 toScene_;
  bool shines_;
};

}  // namespace candela::reference
