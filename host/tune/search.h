// Looks for the fastest candidate, without knowing how one is measured.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "host/bench/sweep_report.h"
#include "host/tune/dimensions.h"

namespace candela::tune {

/// What one candidate took on each scene, always in the same order of scenes.
struct Row {
  Candidate candidate;
  std::vector<bench::SweepRow> scenes;

  /// Whether it gave the right image of every scene.
  bool agrees() const;
};

/// Candidates that were measured in turn. The first is what is built in, to which the others are held.
struct Round {
  std::string purpose;  ///< e.g. "layout, loads"; the last one's is "confirmation"
  std::vector<Row> rows;
};

/// How many times as fast as `base`, as the geometric mean over the scenes of the ratios of median times; 0 if either
/// image is wrong.
double gain(const Row& base, const Row& row);
/// Twice the standard error of the logarithm of gain(): medians of n runs with a median absolute deviation m are taken
/// to have the error 1.2533 * 1.4826 m / sqrt(n) of a normal distribution's.
double noise(const Row& base, const Row& row);
/// Whether gain() is beyond both noise() and kLeastGain.
bool isClearlyFaster(const Row& base, const Row& row);

/// Less is not worth another setting.
inline constexpr double kLeastGain = 1.02;

struct SearchResult {
  std::vector<Round> rounds;
  Candidate chosen;
  double chosenGain = 1;   ///< over what is built in, as the confirmation measured it
  double chosenNoise = 0;  ///< of it
  bool builtInAgrees = true;

  /// Whether every candidate gave the right image.
  bool agree() const;
};

/// Measures each candidate `repeats` times on every scene, in turn, and gives a row for each, in their order.
using Measure = std::function<std::vector<Row>(std::span<const Candidate> candidates, std::uint32_t repeats)>;

/// Stage by stage the fastest candidate that the device has goes on if it is clearly faster than the one before.
/// Whatever is found must then be clearly faster than what is built in, in a last round of 2 `repeats` + 1 runs, which
/// it has not been chosen by. Candidates whose image differs are never chosen; if that is so of what is built in,
/// nothing else is tried.
SearchResult search(const vulkan::DeviceInfo& info, std::uint32_t repeats, const Measure& measure);

}  // namespace candela::tune
