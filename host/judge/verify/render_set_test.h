// The test "Same light?" for two sets of renders by anybody, which docs/comparing-renderers.md defines.
//
// Nothing is assumed about the noise of a render: not its distribution, and not that pixels are independent, since
// reconstruction filters and denoisers make neighbours depend on each other. The render is the unit of replication. The
// values are the means of regions (docs/testing.md) in each render, and a permutation test
// (host/base/statistics/permutation.h) compares all regions together.
#pragma once
#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/judge/verify/conclusion.h"
#include "host/judge/verify/render_set.h"

namespace candela::verify {

/// independent: all renders have random numbers of their own; paired: render i of A and render i of B belong together,
/// for example because they have the same seed; picture: B is one picture with variances (picture_test.h).
enum class SetDesign : std::uint8_t { independent, paired, picture };
inline constexpr std::array<const char*, 3> kSetDesignNames{"independent", "paired", "picture"};

struct SetTestOptions {
  SetDesign design = SetDesign::independent;
  double alpha = 1e-4;                    ///< probability of a false alarm, in [statistics::kMinPermutationLevel, 1)
  double maxOverlooked = kMaxOverlooked;  ///< fraction of the image mean
  std::uint32_t threads = 0;              ///< 0: one for each core
};

/// The first side of the regions is A, the reference B. Their p-values are adjusted for all regions.
struct SetTestResult : RegionTests {
  SetTestOptions options;
  std::size_t countA = 0, countB = 0;  ///< renders
  std::uint32_t significandBits = 24;  ///< of the least precise file
  double pValue = 1;                   ///< of the whole test
  double minPValue = 1;                ///< the smallest one that so many renders can have; 0 for a picture
  std::uint64_t divisions = 1;         ///< of the renders that were evaluated; 0 for a picture
  bool isExhaustive = true;            ///< these are all divisions
  bool hasEqualPairs = false;          ///< the renders of each pair are equal in all regions, so that nothing is open

  bool differs() const { return pValue <= options.alpha; }
  Conclusion conclusion() const;
  /// Returns what leaves a test that found no difference undecided.
  Doubt doubt() const;
  /// Returns one or more sentences with the result and its certainty.
  std::string verdict() const;
};

/// The relative difference of two means with the ends of its 95 % confidence interval, by Welch's standard error.
struct RelativeDifference {
  double value = 0, low = 0, high = 0;
};
/// Returns it as fractions of the magnitude of the reference's mean, which must not be 0. The interval is for one
/// region, whichever is asked for: it does not account for a choice among many.
RelativeDifference relativeDifferenceOf(const RegionResult& result);

/// Tests two sets of at least one render each, with equal windows and frames. Pairs need equal numbers of renders.
SetTestResult testRenderSets(const RenderSet& a, const RenderSet& b, const SetTestOptions& options);

/// Returns the relative difference that rounding may cause in files of this precision.
double roundingOf(std::uint32_t significandBits);

/// Returns the smallest number of renders on each side, or of pairs, that can have a p-value of at most `alpha`.
std::size_t minRenders(SetDesign design, double alpha);

/// Returns lines of text, each ending in a newline; the last one is the verdict.
std::string toText(const SetTestResult& result);
nlohmann::ordered_json toJson(const SetTestResult& result);

}  // namespace candela::verify
