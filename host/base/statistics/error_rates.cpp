// Closed-form levels and increments of the spending function.
#include "host/base/statistics/error_rates.h"

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numbers>

namespace candela::statistics {

// 1 - (1 - alpha)^(1/tests), without cancellation.
double sidakLevel(double alpha, std::uint64_t tests) {
  return -std::expm1(std::log1p(-alpha) / static_cast<double>(tests));
}

double sidakPValue(double pValue, std::uint64_t tests) {
  return -std::expm1(static_cast<double>(tests) * std::log1p(-pValue));
}

double spentAlpha(double alpha, double information) { return alpha * std::log1p((std::numbers::e - 1) * information); }

double levelOfLook(double alpha, std::uint32_t look, std::uint32_t looks) {
  const double step = 1.0 / looks;
  return spentAlpha(alpha, look * step) - spentAlpha(alpha, (look - 1) * step);
}

double binomialTail(std::uint64_t count, std::uint64_t trials, double p) {
  if (count == 0) return 1;
  const boost::math::binomial distribution(static_cast<double>(trials), p);
  return boost::math::cdf(boost::math::complement(distribution, static_cast<double>(count) - 1));
}

}  // namespace candela::statistics
