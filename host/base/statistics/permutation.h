// Permutation tests of several quantities at once, whose unit of replication is the row: one render, with its value of
// every quantity. Quantities of a row may depend on each other in any way, as neighbouring pixels do.
//
// If both groups have the same distribution, every division of the rows into groups of these sizes is equally probable,
// whatever that distribution is (Fisher 1935; Pitman 1937). The p-value is therefore the fraction of the divisions
// whose score is at least that of the data: exact where all divisions are evaluated, and else (b + 1) / (m + 1) for b
// of m random divisions (Phipson and Smyth, Statistical Applications in Genetics and Molecular Biology 9, 2010), which
// is valid for any m. The data themselves are one of the divisions. Pairs exchange the sign of their differences
// instead.
//
// The score of a division is the largest over families of quantities of -log(n P), where n is the number of quantities
// of the family, and P the smallest two-sided tail probability of their Welch statistics (Student's one-sample
// statistic for pairs), each by Student's distribution with its own degrees of freedom of Welch and Satterthwaite, in
// Wallace's approximation. These probabilities only make quantities and families comparable: an image mean does not
// have to reach what the maximum of thousands of tiles reaches by chance. They have no influence on the level, which
// the permutation guarantees. The maximum of the score over quantities adjusts their p-values for all of them together
// (Westfall and Young 1993). Since the statistics are studentised, the test is also asymptotically valid for groups of
// equal means and unequal variances (Janssen, Statistics and Probability Letters 36, 1997). With few rows, unequal
// variances can multiply the rate of false alarms. The score of the data is therefore also compared with those of
// divisions that exchange values in units of the standard deviation of their group, and the larger p-value counts. It
// is never smaller than the exact one. docs/comparing-renderers.md defines both, and has the measured rates.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace candela::statistics {

/// One row for each render, with the values of all quantities. All rows have the same length.
using Rows = std::vector<std::vector<double>>;

/// Returns the values of one quantity.
std::vector<double> column(const Rows& rows, std::size_t quantity);

/// The smallest level for which testGroups() and testPairs() evaluate enough divisions.
inline constexpr double kMinPermutationLevel = 1e-6;

/// The quantities that are tested, and the level.
struct PermutationPlan {
  std::vector<double> margins;        ///< for each quantity, >= 0: differences of means up to this do not count
  std::vector<std::size_t> families;  ///< numbers of quantities of consecutive families, which add up to all
  double alpha = 1e-4;                ///< in [kMinPermutationLevel, 1): decides the number of random divisions
  std::uint64_t seed = 0;             ///< of random divisions
  std::uint32_t threads = 1;          ///< 0: one for each core; the result does not depend on it
};

struct PermutationTest {
  std::uint64_t divisions = 1;  ///< of the values that were evaluated, with that of the data
  bool isExhaustive = true;     ///< all of them
  double minPValue = 1;         ///< the smallest p-value that these numbers of rows, and of divisions, can have
  double pValue = 1;            ///< of all quantities together
  std::vector<double> t;        ///< for each quantity, >= 0; infinite for a difference without any variance
  std::vector<double> pValues;  ///< for each quantity, adjusted for all of them
  std::vector<double> tails;    ///< for each quantity, the tail probability of its t if it stood alone
  /// For each family, the tail probability below which a quantity is significant at `alpha`; 0 if none is.
  std::vector<double> criticalTails;
};

/// Tests whether two independent groups of at least one row each have equal means. The variance of a group of a single
/// row is taken to be that of the other group. Two single rows have the p-value 1.
PermutationTest testGroups(const Rows& a, const Rows& b, const PermutationPlan& plan);

/// Tests whether the differences of at least one pair, one row for each, have the mean 0: their signs are exchanged.
PermutationTest testPairs(const Rows& differences, const PermutationPlan& plan);

}  // namespace candela::statistics
