// The table of the lights that paths sample explicitly: docs/light-transport.md section 6.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "host/reference/light.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::reference {

/// An entry of the table and the probability of being chosen.
struct LightChoice {
  std::uint32_t entry;
  double probability;
};

class LightTable {
 public:
  /// Depends on `nextEventEstimation` and `oneSided` of the settings.
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
  /// The same for the background, which `ray` finds.
  double backgroundPdf(const Ray& ray) const;

 private:
  struct Entry {
    Light light;
    double weight;
  };
  static constexpr std::uint32_t kNoEntry = 0xffffffffu;

  void collectEmitter(const scene::Scene& scene, std::uint32_t primitive, bool oneSided);
  void collectBackground();
  /// Returns the index of the entry.
  std::uint32_t add(const Light& light);
  void computeThresholds();
  double probability(std::uint32_t entry) const;
  /// Of `entry`, or 0 for kNoEntry.
  double pdfOf(std::uint32_t entry, const Ray& ray, double distance) const;

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> thresholds_;
  std::vector<std::uint32_t> entryOfPrimitive_;
  std::uint32_t entryOfBackground_ = kNoEntry;
};

}  // namespace candela::reference
