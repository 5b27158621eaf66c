// Mixtures of exponential supermartingales.
#include "host/base/statistics/self_normalised.h"

#include <algorithm>
#include <cmath>

namespace candela::statistics {
namespace {

constexpr int kMinExponent = -40;  // half octaves
constexpr int kMaxExponent = 56;
constexpr int kRateCount = kMaxExponent - kMinExponent + 1;

template <class Visit>
void visitRates(double scale, Visit visit) {
  for (int i = kMinExponent; i <= kMaxExponent; ++i) visit(std::exp2(0.5 * i) / scale);
}

}  // namespace

double evidence(const SelfNormalisedSum& values, double scale) {
  const auto exponentOf = [&](double rate) { return rate * (values.sum - 0.5 * rate * values.squares); };
  double largest = -HUGE_VAL;
  visitRates(scale, [&](double rate) { largest = std::max(largest, exponentOf(rate)); });
  double sum = 0;
  visitRates(scale, [&](double rate) { sum += std::exp(exponentOf(rate) - largest); });
  return largest + std::log(sum / kRateCount);
}

double pValueOf(const SelfNormalisedSum& values, double scale) {
  return std::exp(-std::max(0.0, evidence(values, scale)));
}

double criticalSum(double squares, double scale, double level) {
  const double needed = std::log(kRateCount / level);
  double minimum = HUGE_VAL;
  visitRates(scale, [&](double rate) { minimum = std::min(minimum, needed / rate + 0.5 * rate * squares); });
  return minimum;
}

}  // namespace candela::statistics
