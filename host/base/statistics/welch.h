// Welch's t-test: whether two samples of unequal variance have the same mean.
#pragma once
#include <cstddef>
#include <span>

namespace candela::statistics {

struct Summary {
  std::size_t count = 0;
  double mean = 0;
  double variance = 0;  ///< unbiased; 0 for fewer than two values

  /// Returns the variance of the mean.
  double squaredError() const { return count == 0 ? 0 : variance / static_cast<double>(count); }
};
Summary summarise(std::span<const double> values);

/// An estimate of a mean, with its uncertainty.
struct Estimate {
  double mean = 0;
  double squaredError = 0;      ///< variance of the mean
  double degreesOfFreedom = 0;  ///< degrees of freedom of squaredError, > 0; meaningless if squaredError is 0
};
/// Returns the estimate from a sample of at least two values.
Estimate estimateOf(const Summary& summary);

struct WelchTest {
  double difference = 0;        ///< mean of a - mean of b
  double standardError = 0;     ///< standard error of the difference
  double degreesOfFreedom = 0;  ///< by Welch and Satterthwaite; 0 if neither sample varies
  double t = 0;                 ///< max(|difference| - margin, 0) / standardError; 0 if neither sample varies
  double pValue = 1;  ///< two-sided; if neither sample varies, 1 for a difference within the margin and else 0
};
/// Tests whether two independent means differ by more than `margin` >= 0 (Welch, Biometrika 34, 1947).
WelchTest welch(const Estimate& a, const Estimate& b, double margin = 0);
/// Tests two samples, each of at least two values, in the same way.
WelchTest welch(const Summary& a, const Summary& b, double margin = 0);

/// Returns the |t| that is exceeded with probability `pValue`, in (0, 1], if both means are equal; `degreesOfFreedom` >
/// 0.
double criticalT(double pValue, double degreesOfFreedom);
/// Returns the true difference, in standard errors, at which t exceeds `criticalT` >= 0 with probability `power`, in
/// (0, 1): t has the noncentral distribution. Infinite if `criticalT` is; `degreesOfFreedom` > 0.
double detectableShift(double criticalT, double degreesOfFreedom, double power);
/// Returns the z that a standard normal variable does not exceed with `probability`, in (0, 1).
double normalQuantile(double probability);

}  // namespace candela::statistics
