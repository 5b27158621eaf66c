// Searches for the fastest candidate, independently of how candidates are measured.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "host/measure/bench/render_rows.h"
#include "host/measure/tune/dimensions.h"

namespace candela::tune {

/// The measurements of one candidate on each scene. The order of scenes is always the same.
struct Row {
  Candidate candidate;
  std::vector<bench::RenderRow> scenes;

  /// Returns whether the candidate gave the correct image of every scene.
  bool agrees() const;
};

/// Candidates that were measured interleaved. The first is the built-in choice, with which the others are compared.
struct Round {
  std::string purpose;  ///< e.g. "layout, loads"; the last one's is "confirmation"
  std::vector<Row> rows;
};

/// Returns the speed relative to `base`: the geometric mean over the scenes of the ratios of median times; 0 if either
/// image is wrong.
double gain(const Row& base, const Row& row);
/// Returns twice the standard error of the logarithm of gain(). The error of the median of n runs with a median
/// absolute deviation m is taken as that of a normal distribution, 1.2533 * 1.4826 m / sqrt(n).
double noise(const Row& base, const Row& row);
/// Returns whether gain() exceeds both noise() and kMinGain.
bool isClearlyFaster(const Row& base, const Row& row);

/// A smaller gain does not justify another setting.
inline constexpr double kMinGain = 1.02;

struct SearchResult {
  std::vector<Round> rounds;
  Candidate chosen;
  double chosenGain = 1;   ///< gain over the built-in choice, as measured by the confirmation
  double chosenNoise = 0;  ///< noise of chosenGain
  bool builtInAgrees = true;
  bool tunesLayout = true;  ///< false: all scenes have too few primitives for a BVH, so that layouts are not compared

  /// Returns whether every candidate gave the correct image.
  bool agree() const;
};

/// Measures each candidate `repeats` times on every scene, interleaved, and returns a row for each, in their order.
using Measure = std::function<std::vector<Row>(std::span<const Candidate> candidates, std::uint32_t repeats)>;

/// In each stage, the fastest candidate that the device supports replaces the best one so far if it is clearly faster.
/// The result must then be clearly faster than the built-in choice in a last round of 2 `repeats` + 1 runs, which is
/// independent of its selection. Candidates whose image differs are never chosen; if the image of the built-in choice
/// is wrong, nothing else is tried.
SearchResult search(const vulkan::DeviceInfo& info, std::uint32_t repeats, const Measure& measure);

}  // namespace candela::tune
