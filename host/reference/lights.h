// The lights that paths sample explicitly: docs/light-transport.md section 6.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "host/reference/geometry.h"
#include "host/reference/sampling.h"
#include "host/reference/surface.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::reference {

/// A place in the table and the probability of being chosen.
struct LightChoice {
  std::uint32_t entry;
  double probability;
};

/// A lit point as seen from a surface.
struct LightSample {
  dvec3 wi;
  double distance;
  dvec3 radiance;             ///< pi times the colour for a point light
  std::optional<double> pdf;  ///< per solid angle, given the choice; none: a point light, which only samples find
  std::uint32_t primitive;    ///< kNoPrimitive for a point light
};

class LightTable {
 public:
  /// Of `settings`, `nextEventEstimation` and `oneSided` count. The scene must outlive the object.
  LightTable(const scene::Scene& scene, const render::RenderSettings& settings);

  /// Whether there is a light of positive weight.
  bool canChoose() const { return !thresholds_.empty() && thresholds_.back() > 0; }
  /// Upper bounds, exclusive, of the 24-bit numbers that choose each entry.
  const std::vector<std::uint32_t>& thresholds() const { return thresholds_; }

  /// `word`: the random number of the light choice. Only where canChoose().
  LightChoice choose(std::uint32_t word) const;
  /// Nothing where that light sends no light to `surface` by these numbers.
  std::optional<LightSample> sample(std::uint32_t entry, const Surface& surface, const dvec2& u) const;
  /// Density, per solid angle and times the choice's probability, with which light samples find the hit of `ray` on
  /// `surface`; 0 if it is not in the table.
  double pdf(const Ray& ray, double distance, const Surface& surface) const;

 private:
  enum class Kind : std::uint8_t { sphere, triangle, point };
  struct Entry {
    Kind kind;
    std::uint32_t index;  ///< primitive, or point light
    double weight;
  };

  void collect(bool withEmitters);
  void computeThresholds();
  double probability(std::uint32_t entry) const;
  std::optional<LightSample> samplePoint(const Entry& entry, const Surface& surface) const;
  std::optional<LightSample> sampleSphere(const Entry& entry, const Surface& surface, const dvec2& u) const;
  std::optional<LightSample> sampleTriangleArea(const Entry& entry, const Surface& surface, const dvec2& u) const;
  const scene::Material& materialOf(const Entry& entry) const;

  const scene::Scene& scene_;
  bool oneSided_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> thresholds_;
  std::vector<std::uint32_t> entryOfPrimitive_;
};

}  // namespace candela::reference
