// The environment: taps of its map, and their choice by an alias table (docs/light-transport.md section 6).
#pragma once
#include <cstdint>
#include <vector>

#include "host/reference/light.h"
#include "host/reference/sampling.h"
#include "host/scene/environment.h"

namespace candela::reference {

/// Chooses texels with probabilities that are exactly in proportion to integer weights.
class AliasTable {
 public:
  /// The sum of the weights is `mean` times their number, or 0. `mean` is at most 2^24.
  AliasTable(const std::vector<std::uint64_t>& weights, std::uint64_t mean);

  /// `number` is uniform among all words of 64 bits. The sum of the weights is not 0.
  std::uint32_t choose(std::uint64_t number) const;

 private:
  struct Bin {
    std::uint32_t threshold;
    std::uint32_t alias;
  };
  std::vector<Bin> bins_;
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
  /// Returns a sample, farther away than any surface. `choice` is a uniform word of 64 bits, `point` uniform in the
  /// unit square.
  std::optional<LightSample> sample(std::uint64_t choice, const dvec2& point) const;

 private:
  double pdf(std::uint32_t texel, double sine) const;

  const scene::Environment& environment_;
  AliasTable table_;
  glm::dmat3 toScene_;
  bool shines_;
};

}  // namespace candela::reference
