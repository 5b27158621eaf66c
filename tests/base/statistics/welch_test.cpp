// Welch's t-test, compared with values computed by hand, and its rate of false alarms.
#include "host/base/statistics/welch.h"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

namespace candela::statistics {
namespace {

TEST_CASE("a summary has the mean and the unbiased variance") {
  const Summary summary = summarise(std::vector{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0});
  CHECK(summary.count == 8);
  CHECK(summary.mean == Approx(5));
  CHECK(summary.variance == Approx(32.0 / 7));
  CHECK(summary.squaredError() == Approx(4.0 / 7));
}

TEST_CASE("the variance of large numbers that hardly differ does not cancel") {
  const Summary summary = summarise(std::vector{1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16});
  CHECK(summary.variance == Approx(30));
}

// The expected values are computed by hand from the formulas, p by numerical integration of Student's density.
TEST_CASE("Welch's test gives the values of a worked example") {
  const std::vector<double> a{27.5, 21.0, 19.0, 23.6, 17.0, 17.9, 16.9, 20.1, 21.9, 22.6, 23.1, 19.6, 19.0, 21.7, 21.4};
  const std::vector<double> b{27.1, 22.0, 20.8, 23.4, 23.4, 23.5, 25.8, 22.0, 24.8, 20.2, 21.9, 22.1, 22.9, 30.5, 25.4};
  const WelchTest test = welch(summarise(a), summarise(b));
  CHECK(test.t == Approx(2.903126).margin(1e-6));
  CHECK(test.degreesOfFreedom == Approx(27.92664).margin(1e-5));
  CHECK(test.pValue == Approx(0.0071387).margin(1e-7));
}

TEST_CASE("samples without variance differ with certainty, or not at all") {
  const Summary one = summarise(std::vector{1.0, 1.0, 1.0});
  const Summary two = summarise(std::vector{2.0, 2.0, 2.0});
  CHECK(welch(one, one).pValue == 1);
  CHECK(welch(one, two).pValue == 0);
  CHECK(welch(one, two, 1.0).pValue == 1);
}

TEST_CASE("only a difference beyond the margin counts") {
  const Summary a = summarise(std::vector{1.0, 2.0, 3.0});
  const Summary b = summarise(std::vector{3.0, 4.0, 5.0});
  CHECK(welch(a, b, 2.0).pValue == 1);
  CHECK(welch(a, b, 0.5).t == Approx(0.75 * welch(a, b).t));
  CHECK(welch(a, b, 0.5).difference == -2);
}

TEST_CASE("a critical t is exceeded with the stated probability") {
  CHECK(criticalT(0.05, 10) == Approx(2.228139).margin(1e-6));
  CHECK(criticalT(0.05, 1e9) == Approx(1.959964).margin(1e-6));
  CHECK(criticalT(1e-9, 62) > 7);
  CHECK(normalQuantile(0.99) == Approx(2.326348).margin(1e-6));
}

TEST_CASE("equal means are rejected with the probability of the level for any variances") {
  std::mt19937 random(7);
  std::normal_distribution<double> narrow(3, 1);
  std::normal_distribution<double> wide(3, 9);
  constexpr int kRuns = 4000;
  int alarms = 0;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<double> a(32), b(32);
    for (double& value : a) value = narrow(random);
    for (double& value : b) value = wide(random);
    alarms += welch(summarise(a), summarise(b)).pValue < 0.05 ? 1 : 0;
  }
  // 200 expected, standard deviation 13.8.
  CHECK(alarms > 145);
  CHECK(alarms < 255);
}

}  // namespace
}  // namespace candela::statistics
