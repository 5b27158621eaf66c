// The table of the lights that are sampled: docs/light-transport.md section 6.
#pragma once
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "host/scene/scene.h"
#include "host/scene/shape.h"
#include "host/trace/reference/light.h"
#include "host/trace/render/settings.h"

namespace candela::reference {

/// An entry of the table, and the probability of choosing it.
struct LightChoice {
  std::uint32_t entry;
  double probability;
};

class LightTable {
 public:
  /// Depends on `nextEventEstimation` and `oneSided` of the settings. The scene must outlive the object.
  LightTable(const scene::Scene& scene, const render::RenderSettings& settings);

  /// Returns whether there is a light of positive weight.
  bool canChoose() const { return !thresholds_.empty() && thresholds_.back() > 0; }
  /// Exclusive upper bounds of the 24-bit numbers that choose each entry.
  const std::vector<std::uint32_t>& thresholds() const { return thresholds_; }

  /// `word` is the random number of the light choice. Requires canChoose().
  LightChoice choose(std::uint32_t word) const;
  /// Returns nothing if the light does not illuminate `surface` with these numbers, or is a copy of its primitive.
  std::optional<LightSample> sample(std::uint32_t entry, const Surface& surface, const dvec2& u) const;
  /// Returns the density, per solid angle and times the probability of the choice, with which light sampling chooses
  /// the hit of `ray` on `surface`; 0 if the primitive is not in the table.
  double pdf(const Ray& ray, double distance, const Surface& surface) const;
  /// Returns whether an entry is the environment, which sample() does not sample.
  bool isEnvironment(std::uint32_t entry) const { return entry == entryOfEnvironment_; }
  /// Returns the probability of choosing the environment; 0 if it is not in the table.
  double environmentProbability() const;

 private:
  static constexpr std::uint32_t kNoEntry = 0xffffffffu;

  struct Entry {
    Light light;
    double weight;
    std::uint32_t primitive;  ///< kNoPrimitive for a light that is not a primitive
    scene::Shape shape{};     ///< of the primitive
  };

  /// Adds a primitive that emits.
  void addEmitter(std::uint32_t primitive, const scene::Primitive& emitter, bool oneSided);
  /// Returns the index of the entry.
  std::uint32_t add(const Light& light, std::uint32_t primitive = kNoPrimitive);
  bool isOnCopy(const Entry& entry, const Surface& surface) const;
  /// Sums of the entries' weights.
  std::vector<double> groupWeights() const;
  /// The probability of each group that has an entry of positive weight.
  std::vector<double> groupProbabilities() const;
  /// Raises the weights of lights that no ray finds, so that none is lost beside a much brighter one.
  void raisePointWeights();
  void computeThresholds(const std::vector<double>& groups);
  double probability(std::uint32_t entry) const;

  const scene::Scene* scene_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> thresholds_;
  std::unordered_map<std::uint32_t, std::uint32_t> entryOfPrimitive_;
  std::uint32_t entryOfEnvironment_ = kNoEntry;
};

}  // namespace candela::reference
