// The participants of a sample, of which one may be odd: decisions.h defines it.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "host/judge/verify/decisions.h"

namespace candela::verify {

/// Returns the maximum of the channels.
inline double maxChannel(const glm::dvec3& c) { return std::max({c.x, c.y, c.z}); }

/// Values that agree with each other.
class Consensus {
 public:
  explicit Consensus(double quantum) : quantum_(quantum) {}

  void add(const glm::dvec3& value) { values_.push_back(value); }

  bool excludes(const glm::dvec3& value) const {
    glm::dvec3 mean(0);
    for (const glm::dvec3& other : values_) mean += other / static_cast<double>(values_.size());
    double spread = 0;
    for (const glm::dvec3& other : values_) spread = std::max(spread, maxChannel(glm::abs(other - mean)));
    const double tolerance = kSpread * spread + kSpreadFloor * maxChannel(glm::abs(mean)) + quantum_;
    return maxChannel(glm::abs(value - mean)) > tolerance;
  }

 private:
  double quantum_;
  std::vector<glm::dvec3> values_;
};

/// One sample: the replicas, then the device, of which only the value is known.
struct Participants {
  double quantum;  ///< filmQuantum() of the device's film
  std::array<glm::dvec3, kReplicas + 1> values;
  std::array<std::uint64_t, kReplicas> decisions;

  Consensus othersOf(std::size_t odd) const {
    Consensus others(quantum);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i != odd) others.add(values[i]);
    }
    return others;
  }

  bool othersDecideAlike(std::size_t odd) const {
    std::optional<std::uint64_t> first;
    for (std::size_t i = 0; i < kReplicas; ++i) {
      if (i == odd) continue;
      if (!first) first = decisions[i];
      if (decisions[i] != *first) return false;
    }
    return true;
  }

  std::optional<std::size_t> odd() const {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (othersDecideAlike(i) && othersOf(i).excludes(values[i])) return i;
    }
    return std::nullopt;
  }
};

}  // namespace candela::verify
