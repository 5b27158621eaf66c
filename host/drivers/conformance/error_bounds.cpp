// Computes intervals of permitted results.
#include "host/drivers/conformance/error_bounds.h"

#include <algorithm>
#include <cmath>

namespace candela::conformance {
namespace {

constexpr int kFractionBits = 23;
constexpr int kMinExponent = -126;
constexpr double kRsqrtUlps = 2;
constexpr double kDivisionUlps = 2.5;
constexpr double kLogUlps = 3;

Interval reciprocal(const Interval& x) { return {1 / x.high, 1 / x.low}; }

}  // namespace

double unitInLastPlace(double value) {
  const int exponent = value == 0 ? kMinExponent : std::max(std::ilogb(value), kMinExponent);
  return std::ldexp(1.0, exponent - kFractionBits);
}

Interval withinUlps(const Interval& exact, double ulps) {
  return {exact.low - ulps * unitInLastPlace(exact.low), exact.high + ulps * unitInLastPlace(exact.high)};
}

Interval withinUlps(double exact, double ulps) { return withinUlps(Interval{exact, exact}, ulps); }
Interval withinError(double exact, double error) { return {exact - error, exact + error}; }

Interval correctlyRounded(double exact) {
  const auto nearest = static_cast<float>(exact);
  if (double{nearest} == exact) return {exact, exact};
  const float other = std::nextafter(nearest, double{nearest} < exact ? HUGE_VALF : -HUGE_VALF);
  return {std::min(double{nearest}, double{other}), std::max(double{nearest}, double{other})};
}

// sqrt(x) inherits its precision from 1 / inversesqrt(x).
Interval boundOfSqrt(double x) {
  return withinUlps(reciprocal(withinUlps(1 / std::sqrt(x), kRsqrtUlps)), kDivisionUlps);
}

// exp2(x) has 3 + 2 |x| ulps.
Interval boundOfExp2(const Interval& x) {
  const double ulps = 3 + 2 * std::max(std::abs(x.low), std::abs(x.high));
  return withinUlps(Interval{std::exp2(x.low), std::exp2(x.high)}, ulps);
}

Interval boundOfLog2(double x) {
  constexpr double kAbsoluteError = 0x1p-21;  // from 0.5 to 2
  const double exact = std::log2(x);
  return x >= 0.5 && x <= 2 ? withinError(exact, kAbsoluteError) : withinUlps(exact, kLogUlps);
}

// pow(x, y) inherits its precision from exp2(y log2(x)).
Interval boundOfPow(double x, double y) {
  const Interval logarithm = boundOfLog2(x);
  const double first = y * logarithm.low, second = y * logarithm.high;
  return boundOfExp2(withinUlps(Interval{std::min(first, second), std::max(first, second)}, 1));
}

}  // namespace candela::conformance
