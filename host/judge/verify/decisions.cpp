// Finds the odd participant of each sample, confirms it, and counts.
#include "host/judge/verify/decisions.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "host/base/statistics/error_rates.h"

namespace candela::verify {
namespace {

/// Returns the maximum of the channels.
double maxChannel(const glm::dvec3& c) { return std::max({c.x, c.y, c.z}); }

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

constexpr std::size_t kDevice = kReplicas;

struct Candidate {
  std::uint32_t x, y;
  std::size_t odd;
  Participants participants;
};

// Returns whether kConfirmations more replicas agree with the others.
bool isConfirmed(const Candidate& candidate, render::ReplicaSource& reference) {
  const Participants& participants = candidate.participants;
  const glm::dvec3& value = participants.values[candidate.odd];
  const std::uint64_t decisions = participants.decisions[candidate.odd == 0 ? 1 : 0];
  Consensus others = participants.othersOf(candidate.odd);
  for (std::uint32_t i = 0; i < kConfirmations; ++i) {
    const render::Replica replica = reference.replica({candidate.x, candidate.y, 0}, kReplicas + i);
    others.add(replica.radiance);
    if (replica.decisions != decisions || !others.excludes(value)) return false;
  }
  return true;
}

// Orders pixels as by chance, the same in every run.
std::uint32_t orderOf(const Candidate& candidate) {
  std::uint32_t hash = candidate.x * 0x9e3779b9u ^ candidate.y * 0x85ebca6bu;
  hash = (hash ^ (hash >> 16)) * 0x7feb352du;
  return (hash ^ (hash >> 15)) * 0x846ca68bu;
}

class DecisionCounts {
 public:
  DecisionCounts(const image::Film& device, const std::vector<render::Replica>& replicas)
      : device_(device), replicas_(replicas) {}

  DecisionTest run(render::ReplicaSource& reference, double level) {
    test_.isPossible = true;
    test_.level = level;
    for (std::uint32_t y = 0; y < device_.height(); ++y) {
      for (std::uint32_t x = 0; x < device_.width(); ++x) addPixel(x, y);
    }
    test_.candidates = candidates_.size();
    std::ranges::sort(candidates_, {}, orderOf);
    if (candidates_.size() > kMaxCandidates) candidates_.erase(candidates_.begin() + kMaxCandidates, candidates_.end());
    for (const Candidate& candidate : candidates_) {
      if (isConfirmed(candidate, reference)) addOdd(candidate);
    }
    if (test_.odd > 0) test_.pValue = statistics::binomialTail(test_.oddDevice, test_.odd, 1.0 / (kReplicas + 1));
    return test_;
  }

 private:
  void addPixel(std::uint32_t x, std::uint32_t y) {
    const render::Replica* const replicas = &replicas_[kReplicas * (std::size_t{y} * device_.width() + x)];
    Participants participants{filmQuantum(device_), {}, {}};
    bool decides = true;
    for (std::size_t i = 0; i < kReplicas; ++i) {
      participants.values[i] = replicas[i].radiance;
      participants.decisions[i] = replicas[i].decisions;
      decides = decides && replicas[i].vertex == 0;
    }
    participants.values[kDevice] = device_.mean(x, y);
    ++test_.pixels;
    if (!decides) addUndecidable(replicas);
    if (const std::optional<std::size_t> odd = participants.odd()) candidates_.push_back({x, y, *odd, participants});
  }

  void addUndecidable(const render::Replica* replicas) {
    ++test_.undecidable;
    for (std::size_t i = 0; i < kReplicas; ++i) {
      if (replicas[i].vertex == 0 || replicas[i].amplification <= test_.amplification) continue;
      test_.amplification = double{replicas[i].amplification};
      test_.vertex = replicas[i].vertex;
    }
  }

  void addOdd(const Candidate& candidate) {
    ++test_.odd;
    if (candidate.odd != kDevice) return;
    ++test_.oddDevice;
    const std::array<glm::dvec3, kReplicas + 1>& values = candidate.participants.values;
    const double difference = maxChannel(glm::abs(values[kDevice] - values.front()));
    if (difference <= test_.worst) return;
    test_.worst = difference;
    test_.worstX = candidate.x;
    test_.worstY = candidate.y;
  }

  const image::Film& device_;
  const std::vector<render::Replica>& replicas_;
  DecisionTest test_;
  std::vector<Candidate> candidates_;
};

}  // namespace

DecisionTest testDecisions(const image::Film& device, render::ReplicaSource& reference, double level) {
  const render::ReplicaRecords records = reference.replicas();
  if (records.replicas.size() != kReplicas * device.pixels().size()) return {};
  return DecisionCounts(device, records.replicas).run(reference, level);
}

}  // namespace candela::verify
