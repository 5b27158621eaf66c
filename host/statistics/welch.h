// Welch's t-test: do two samples of unequal variance have the same mean?
#pragma once
#include <cstddef>
#include <span>

namespace candela::statistics {

struct Summary {
  std::size_t count = 0;
  double mean = 0;
  double variance = 0;  ///< unbiased; 0 for fewer than two values

  /// Of the mean.
  double squaredError() const { return count == 0 ? 0 : variance / static_cast<double>(count); }
};
Summary summarise(std::span<const double> values);

/// A mean, and how well it is known.
struct Estimate {
  double mean = 0;
  double squaredError = 0;      ///< variance of the mean
  double degreesOfFreedom = 0;  ///< of squaredError, > 0; of no meaning where that is 0
};
/// Of a sample of at least two values.
Estimate estimateOf(const Summary& summary);

struct WelchTest {
  double difference = 0;        ///< mean of a - mean of b
  double standardError = 0;     ///< of the difference
  double degreesOfFreedom = 0;  ///< Welch and Satterthwaite's; 0 where neither sample varies
  double t = 0;                 ///< (|difference| - margin, at least 0) / standardError; 0 where neither sample varies
  double pValue = 1;            ///< two-sided; where neither sample varies 1 for a difference within the margin, else 0
};
/// Tests whether two independent means differ by more than `margin` >= 0 (Welch, Biometrika 34, 1947).
WelchTest welch(const Estimate& a, const Estimate& b, double margin = 0);
/// The same of two samples, each of at least two values.
WelchTest welch(const Summary& a, const Summary& b, double margin = 0);

/// The |t| that is exceeded with probability `pValue` in (0, 1] where both means are equal; `degreesOfFreedom` > 0.
double criticalT(double pValue, double degreesOfFreedom);
/// The z that a standard normal variable stays below with `probability` in (0, 1).
double normalQuantile(double probability);

}  // namespace candela::statistics
