// Welch's test, with the distributions of Boost.Math.
#include "host/base/statistics/welch.h"

#include <algorithm>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace candela::statistics {

namespace math = boost::math;

namespace {

// Returns half of the variance of the squared error.
double uncertaintyOf(const Estimate& estimate) {
  if (estimate.squaredError == 0) return 0;
  return estimate.squaredError * estimate.squaredError / estimate.degreesOfFreedom;
}

}  // namespace

Summary summarise(std::span<const double> values) {
  Summary summary;
  double squares = 0;  // sum of squared deviations from the mean so far (Welford 1962)
  for (const double value : values) {
    ++summary.count;
    const double deviation = value - summary.mean;
    summary.mean += deviation / static_cast<double>(summary.count);
    squares += deviation * (value - summary.mean);
  }
  if (summary.count > 1) summary.variance = squares / static_cast<double>(summary.count - 1);
  return summary;
}

Estimate estimateOf(const Summary& summary) {
  return {summary.mean, summary.squaredError(), static_cast<double>(summary.count) - 1};
}

WelchTest welch(const Summary& a, const Summary& b, double margin) {
  return welch(estimateOf(a), estimateOf(b), margin);
}

WelchTest welch(const Estimate& a, const Estimate& b, double margin) {
  WelchTest test;
  test.difference = a.mean - b.mean;
  const double squaredError = a.squaredError + b.squaredError;
  test.standardError = std::sqrt(squaredError);
  const double excess = std::max(0.0, std::abs(test.difference) - margin);
  if (test.standardError == 0) {
    test.pValue = excess == 0 ? 1 : 0;
    return test;
  }
  test.degreesOfFreedom = squaredError * squaredError / (uncertaintyOf(a) + uncertaintyOf(b));
  test.t = excess / test.standardError;
  const math::students_t distribution(test.degreesOfFreedom);
  test.pValue = 2 * math::cdf(math::complement(distribution, test.t));
  return test;
}

double criticalT(double pValue, double degreesOfFreedom) {
  return math::quantile(math::complement(math::students_t(degreesOfFreedom), pValue / 2));
}

double detectableShift(double criticalT, double degreesOfFreedom, double power) {
  if (std::isinf(criticalT)) return criticalT;
  const auto powerAt = [&](double shift) {
    return math::cdf(math::complement(math::non_central_t(degreesOfFreedom, shift), criticalT));
  };
  double low = 0, high = 1;
  while (powerAt(high) < power) high *= 2;
  constexpr double kAccuracy = 1e-6;
  while (high - low > kAccuracy * high) {
    const double middle = (low + high) / 2;
    (powerAt(middle) < power ? low : high) = middle;
  }
  return high;
}

double normalQuantile(double probability) { return math::quantile(math::normal(), probability); }

}  // namespace candela::statistics
