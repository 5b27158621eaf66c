// The chi-square test of the proofs: values computed by hand, its false alarms, and wrong densities that it must
// reject.
#include "tests/trace/proof/chi_square.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/numbers.h"

using namespace candela::proof;

namespace {

using Counts = std::vector<double>;

constexpr std::size_t kPowerSamples = 1000000;

// Heights z of a cosine hemisphere's directions, by inversion.
Counts countsOfCosine(int rows, std::uint32_t seed) {
  Cells cells(rows, 1);
  for (const glm::vec3& u : randomNumbers(kPowerSamples, seed)) cells.add({std::sqrt(double{u.x}), 0});
  return cells.counts();
}

// Expected where heights have the distribution function z^power; 2 is the cosine's.
Counts expectedOfPower(int rows, double power) {
  Counts expected(static_cast<std::size_t>(rows) + 1);
  for (int i = 0; i < rows; ++i) {
    const double low = double{1} * i / rows, high = (i + 1.0) / rows;
    expected[static_cast<std::size_t>(i)] = kPowerSamples * (std::pow(high, power) - std::pow(low, power));
  }
  return expected;
}

}  // namespace

TEST_CASE("the statistic and its p-value equal those computed by hand") {
  // (15 - 10)^2/10 + (20 - 25)^2/25 = 3.5 with one degree of freedom: p = erfc(sqrt(3.5 / 2)).
  const ChiSquareTest two = chiSquare(Counts{15, 20}, Counts{10, 25});
  CHECK(two.statistic == Approx(3.5));
  CHECK(two.degreesOfFreedom == 1);
  CHECK(two.pValue == Approx(std::erfc(std::sqrt(1.75))));
  // Two degrees of freedom: p = exp(-statistic / 2).
  const ChiSquareTest three = chiSquare(Counts{12, 8, 10}, Counts{10, 10, 10});
  CHECK(three.degreesOfFreedom == 2);
  CHECK(three.pValue == Approx(std::exp(-0.4)));
}

TEST_CASE("cells are pooled until five samples are expected, and the rest joins the last pool") {
  // 1 + 2 + 3 make a pool of 6; 8 and 9 are separate pools.
  const ChiSquareTest pooled = chiSquare(Counts{9, 2, 2, 2, 8}, Counts{8, 1, 3, 2, 9});
  CHECK(pooled.degreesOfFreedom == 2);
  CHECK(pooled.statistic == Approx(1.0 / 8 + 1.0 / 9));
  CHECK(chiSquare(Counts{1, 2}, Counts{2, 1}).degreesOfFreedom == 0);
  CHECK(chiSquare(Counts{1, 2}, Counts{2, 1}).pValue == 1);
}

TEST_CASE("one sample in a cell of probability 0 is rejected") {
  CHECK(chiSquare(Counts{1000, 1000, 1}, Counts{1000, 1001, 0}).pValue == 0);
}

TEST_CASE("correct densities are rejected with the probability of the level") {
  int rejected = 0;
  for (std::uint32_t run = 0; run < 1000; ++run) {
    std::mt19937 random(run);
    Counts counts(50), expected(50, 100);
    for (int i = 0; i < 5000; ++i) ++counts[random() % 50];
    rejected += chiSquare(counts, expected).pValue < 0.05;
  }
  CHECK(rejected >= 30);  // binomial, 1000 runs at 0.05: 50 +- 6.9
  CHECK(rejected <= 70);
}

TEST_CASE("with a million samples, slightly wrong densities are rejected and correct ones are not") {
  const Counts counts = countsOfCosine(64, 1);
  CHECK(chiSquare(counts, expectedOfPower(64, 2)).pValue > 1e-3);
  CHECK(chiSquare(counts, expectedOfPower(64, 2.02)).pValue < 1e-6);  // cosines to the power 1.02
  CHECK(chiSquare(counts, expectedOfPower(64, 1)).pValue == 0);       // without the cosine
  Counts moved = expectedOfPower(64, 2);                              // 1 % too much below, too little above
  for (std::size_t i = 0; i < 64; ++i) moved[i] *= i < 45 ? 1.01 : 0.99;
  CHECK(chiSquare(counts, moved).pValue < 1e-9);
}
