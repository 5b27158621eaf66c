// The self-normalised test: its level with heavy tails and at many looks, its power, and its critical sum.
#include "host/base/statistics/self_normalised.h"

#include <catch2/catch.hpp>
#include <functional>
#include <random>

namespace candela::statistics {
namespace {

// Returns how many of `runs` runs ever reach `level`, with a look after each quarter of `count` values.
int alarmsOf(int runs, int count, double level, const std::function<double(std::mt19937&)>& draw) {
  int alarms = 0;
  for (int run = 0; run < runs; ++run) {
    std::mt19937 random(static_cast<unsigned>(run));
    SelfNormalisedSum values;
    bool alarmed = false;
    for (int i = 1; i <= count; ++i) {
      values.add(draw(random));
      if (i % (count / 4) == 0) alarmed = alarmed || pValueOf(values, 1) <= level;
    }
    alarms += alarmed ? 1 : 0;
  }
  return alarms;
}

double uniform(std::mt19937& random) { return static_cast<double>(random()) * 0x1p-32; }

TEST_CASE("values without a preferred side raise alarms no more often than the level, however heavy their tails") {
  constexpr int kRuns = 1000;
  constexpr double kLevel = 0.05;
  const auto sign = [](std::mt19937& random) { return random() % 2 == 0 ? 1.0 : -1.0; };
  const auto normal = [](std::mt19937& random) { return std::normal_distribution<double>(0, 1e-3)(random); };
  const auto cauchy = [](std::mt19937& random) { return std::cauchy_distribution<double>(0, 1e-4)(random); };
  const auto rare = [&](std::mt19937& random) { return uniform(random) < 0.003 ? sign(random) : 1e-7 * sign(random); };
  for (const auto& draw : {std::function<double(std::mt19937&)>(normal), {cauchy}, {rare}}) {
    CHECK(alarmsOf(kRuns, 400, kLevel, draw) <= 70);  // 50 and three deviations
  }
}

TEST_CASE("a device that always decides one way raises no more alarms than the level, at any rate of flips") {
  // The replica flips with probability 1/2 where rounding can decide, by twice as much; the device always brightens.
  for (const double rate : {1e-3, 0.01, 0.1, 1.0}) {
    const auto draw = [rate](std::mt19937& random) {
      if (uniform(random) >= rate) return -1e-8;
      return 1 - (random() % 2 == 0 ? 2.0 : 0.0);
    };
    CAPTURE(rate);
    CHECK(alarmsOf(500, 1024, 0.05, draw) <= 40);
  }
}

TEST_CASE("one value never convinces, and a few equal ones do not at a strict level") {
  SelfNormalisedSum values;
  values.add(1e3);
  CHECK(pValueOf(values, 1) > 0.6);
  for (int i = 0; i < 9; ++i) values.add(1e3);
  CHECK(pValueOf(values, 1) > 1e-4);
  for (int i = 0; i < 54; ++i) values.add(1e3);
  CHECK(pValueOf(values, 1) < 1e-8);
}

TEST_CASE("an empty sum and a negative one have p-value 1") {
  CHECK(pValueOf({}, 1) == 1);
  CHECK(pValueOf({-3, 2, 10}, 1) == 1);
}

TEST_CASE("the critical sum suffices, 5 % less do not, and the best test would need a tenth less") {
  for (const double squares : {1e-12, 1e-6, 1.0, 1e4}) {
    const double critical = criticalSum(squares, 1, 1e-8);
    CAPTURE(squares);
    CHECK(pValueOf({critical, squares, 1000}, 1) <= 1e-8);
    CHECK(pValueOf({0.95 * critical, squares, 1000}, 1) > 1e-8);
    CHECK(critical < 1.15 * std::sqrt(2 * std::log(1e8) * squares));
    CHECK(critical > std::sqrt(2 * std::log(1e8) * squares));
  }
}

TEST_CASE("a bias that exceeds the critical sum by 2.33 deviations is found in 99 of 100 runs") {
  constexpr int kCount = 4000;
  constexpr double kDeviation = 1e-3;
  const double needed = criticalSum(kCount * kDeviation * kDeviation, 1, 1e-6) +
                        2.4 * kDeviation * std::sqrt(double{kCount});
  const auto draw = [&](std::mt19937& random) {
    return std::normal_distribution<double>(needed / kCount, kDeviation)(random);
  };
  CHECK(alarmsOf(100, kCount, 1e-6, draw) >= 98);
}

}  // namespace
}  // namespace candela::statistics
