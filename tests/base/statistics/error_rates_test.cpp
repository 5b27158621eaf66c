// The division of the probability of false alarms: sums and simulated rates.
#include "host/base/statistics/error_rates.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace candela::statistics {
namespace {

TEST_CASE("independent tests at Sidak's level give the promised false alarms together") {
  CHECK(sidakLevel(0.05, 1) == Approx(0.05));
  CHECK(sidakLevel(0.05, 10) == Approx(0.005116197));
  const double level = sidakLevel(1e-4, 5000);
  CHECK(-std::expm1(5000 * std::log1p(-level)) == Approx(1e-4));
}

TEST_CASE("all looks together spend alpha, and no look spends nothing") {
  for (const std::uint32_t looks : {1u, 2u, 8u}) {
    double sum = 0;
    for (std::uint32_t look = 1; look <= looks; ++look) {
      CHECK(levelOfLook(1e-4, look, looks) > 0);
      sum += levelOfLook(1e-4, look, looks);
    }
    CHECK(sum == Approx(1e-4));
  }
}

TEST_CASE("eight looks at growing samples of one mean give no more false alarms than alpha") {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  constexpr int kRuns = 20000;
  constexpr std::uint32_t kLooks = 8;
  constexpr double kAlpha = 0.05;
  int planned = 0;
  int naive = 0;
  for (int run = 0; run < kRuns; ++run) {
    double sum = 0;
    bool plannedAlarm = false;
    bool naiveAlarm = false;
    for (std::uint32_t look = 1; look <= kLooks; ++look) {
      sum += normal(random);
      const double p = std::erfc(std::abs(sum) / std::sqrt(2.0 * look));
      plannedAlarm |= p < levelOfLook(kAlpha, look, kLooks);
      naiveAlarm |= p < kAlpha;
    }
    planned += plannedAlarm ? 1 : 0;
    naive += naiveAlarm ? 1 : 0;
  }
  CHECK(planned < kAlpha * kRuns);
  CHECK(planned > 0.4 * kAlpha * kRuns);  // the bound is not too wide
  CHECK(naive > 2 * kAlpha * kRuns);      // and it is needed
}

}  // namespace
}  // namespace candela::statistics
