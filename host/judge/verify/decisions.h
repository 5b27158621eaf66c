// The test "Same numbers, same paths?": samples that single precision can decide must be equal.
//
// The reference traces each sample kReplicas times with perturbed arithmetic (host/trace/reference/rounding.h). One of
// the participants, which are the device and the replicas, is *odd* if the others make the same decisions and agree,
// and its value is farther from their mean than kSpread times their own spread. kConfirmations more replicas must then
// side with the others; otherwise the sample is undecidable, and nobody is odd. If the device rounds no worse than a
// replica, each participant is odd equally often (the participants are exchangeable), so that the number of times that
// the device is the odd one has a binomial distribution. Too many of them raise the alarm. No threshold is chosen.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/image/film.h"
#include "host/trace/render/replicas.h"

namespace candela::verify {

inline constexpr std::uint32_t kReplicas = 2;
inline constexpr std::uint32_t kConfirmations = 62;
/// Maximum number of samples for which confirmations are traced. They are chosen by a hash of their pixel.
inline constexpr std::uint32_t kMaxCandidates = 1024;
inline constexpr double kSpread = 16;
/// Differences below this fraction of a value are always tolerated: 16 roundings in single precision.
inline constexpr double kSpreadFloor = 0x1p-20;

/// Returns twice the unit of a film's sums, since both films truncate samples to multiples of it.
inline double filmQuantum(const image::Film& film) { return 0x1p-39 * film.radianceOfOne(); }

struct DecisionTest {
  bool isPossible = false;  ///< false: the reference traced no replicas
  std::uint64_t pixels = 0;
  std::uint64_t undecidable = 0;  ///< replicas decide differently from each other or from the exact sample
  std::uint64_t candidates = 0;   ///< a participant seemed odd; a few of these samples are confirmed
  std::uint64_t odd = 0;          ///< confirmed, of any participant
  std::uint64_t oddDevice = 0;    ///< confirmed, of the device
  double worst = 0;               ///< maximum difference of a channel where the device is odd
  std::uint32_t worstX = 0, worstY = 0;
  double amplification = 0;  ///< maximum over undecidable samples, in units of 2^-24
  std::uint32_t vertex = 0;  ///< at which it is reached, from 1
  double pValue = 1;
  double level = 0;

  bool agrees() const { return pValue >= level; }
  double undecidableFraction() const {
    return pixels == 0 ? 0 : static_cast<double>(undecidable) / static_cast<double>(pixels);
  }
  /// Returns the result in one clause.
  std::string summary() const;
  /// Returns the counts in words, a clause each; nothing if the test is not possible.
  std::vector<std::string> details() const;
  /// Returns the details in one sentence, or the summary if there are none.
  std::string text() const;
  nlohmann::ordered_json json() const;
};

/// Tests the device's film of one sample per pixel at `level`. `reference` is that of a session that has advanced by
/// the same sample, with kReplicas replicas; otherwise the test is not possible, and agrees.
DecisionTest testDecisions(const image::Film& device, render::ReplicaSource& reference, double level);

}  // namespace candela::verify
