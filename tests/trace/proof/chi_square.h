// Pearson's chi-square test of whether counts were drawn with the claimed probabilities.
#pragma once
#include <cstddef>
#include <span>

namespace candela::proof {

/// Cells are pooled, the rarest first, until each pool has this expected count: below it the statistic's distribution
/// is no longer that of chi-square (Cochran, Biometrics 10, 1954).
inline constexpr double kLeastExpected = 5;

struct ChiSquareTest {
  double statistic = 0;
  std::size_t degreesOfFreedom = 0;  ///< pools less one
  double pValue = 1;                 ///< 0 if there are counts where none are expected
};

/// `observed` and `expected` counts of the same cells, neither negative; their totals are equal except for
/// the error of quadrature. With fewer than two pools there is no test, and the p-value is 1.
ChiSquareTest chiSquare(std::span<const double> observed, std::span<const double> expected);

/// Fails the running test case unless the counts agree with the expected ones, at a level that lets the suite of all
/// such checks, on one side, give a false alarm in one of a thousand choices of its seeds (after Sidak).
void checkCounts(std::span<const double> observed, std::span<const double> expected);

}  // namespace candela::proof
