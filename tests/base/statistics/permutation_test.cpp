// Permutation tests, compared with p-values counted by hand and by complete enumeration, and their false alarms.
#include "host/base/statistics/permutation.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "host/base/statistics/error_rates.h"
#include "host/base/statistics/welch.h"

namespace candela::statistics {
namespace {

PermutationPlan planFor(std::size_t quantities, double alpha = 0.05) {
  return {std::vector<double>(quantities), {quantities}, alpha};
}

// One quantity, with one value for each row.
Rows column(const std::vector<double>& values) {
  Rows rows;
  for (const double value : values) rows.push_back({value});
  return rows;
}

Rows normalRows(std::mt19937& random, std::size_t count, std::size_t quantities, double mean = 0) {
  std::normal_distribution<double> normal(mean);
  Rows rows(count, std::vector<double>(quantities));
  for (auto& row : rows) {
    for (double& value : row) value = normal(random);
  }
  return rows;
}

std::vector<double> valuesOf(const Rows& rows, std::size_t quantity) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[quantity]);
  return values;
}

// The smallest Welch p-value of all quantities, by the independent implementation.
double smallestWelch(const Rows& a, const Rows& b) {
  double smallest = 1;
  for (std::size_t q = 0; q < a.front().size(); ++q) {
    smallest = std::min(smallest, welch(summarise(valuesOf(a, q)), summarise(valuesOf(b, q))).pValue);
  }
  return smallest;
}

Rows scaled(Rows rows, double factor) {
  for (auto& row : rows) {
    for (double& value : row) value *= factor;
  }
  return rows;
}

// Rows in units of the standard deviation of their group, whose sum is 0. A difference of more than two standard errors
// is reduced to two.
struct Standardised {
  Rows a, b;
  std::vector<double> deviationsOfA, deviationsOfB;
};

Standardised standardised(Rows a, Rows b) {
  Standardised rows;
  for (std::size_t q = 0; q < a.front().size(); ++q) {
    const double sA = std::sqrt(summarise(valuesOf(a, q)).variance), sB = std::sqrt(summarise(valuesOf(b, q)).variance);
    const WelchTest test = welch(summarise(valuesOf(a, q)), summarise(valuesOf(b, q)));
    for (auto& row : a) row[q] -= test.difference * (test.t > 2 ? 1 - 2 / test.t : 0);
    double sum = 0;
    for (auto& row : a) sum += row[q] /= sA;
    for (auto& row : b) sum += row[q] /= sB;
    const double centre = sum / (static_cast<double>(a.size()) / sA + static_cast<double>(b.size()) / sB);
    for (auto& row : a) row[q] -= centre / sA;
    for (auto& row : b) row[q] -= centre / sB;
    rows.deviationsOfA.push_back(sA);
    rows.deviationsOfB.push_back(sB);
  }
  rows.a = a;
  rows.b = b;
  return rows;
}

// The smallest p-value of a division of standardised rows, as docs/comparing-renderers.md defines it.
double smallestStandardised(const Rows& a, const Rows& b, const Standardised& data) {
  const auto n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
  double smallest = 1;
  for (std::size_t q = 0; q < a.front().size(); ++q) {
    const double squareA = data.deviationsOfA[q] * data.deviationsOfA[q];
    const double squareB = data.deviationsOfB[q] * data.deviationsOfB[q];
    const Summary first = summarise(valuesOf(a, q)), second = summarise(valuesOf(b, q));
    const double difference = (first.mean - second.mean) * std::sqrt((m * squareA + n * squareB) / (n + m));
    smallest = std::min(smallest, welch(Estimate{difference, squareA * first.squaredError(), n - 1},
                                        Estimate{0, squareB * second.squaredError(), m - 1})
                                      .pValue);
  }
  return smallest;
}

// The fraction of all divisions whose smallest p-value is at most that of the data. The first is that of the data.
template <class SmallestPValue>
double enumeratedPValue(const Rows& a, const Rows& b, double data, SmallestPValue smallestPValue) {
  std::vector<bool> isInB(a.size() + b.size());
  std::fill(isInB.begin() + static_cast<std::ptrdiff_t>(a.size()), isInB.end(), true);
  int divisions = 0, extreme = 0;
  do {
    Rows first, second;
    for (std::size_t i = 0; i < isInB.size(); ++i) {
      (isInB[i] ? second : first).push_back(i < a.size() ? a[i] : b[i - a.size()]);
    }
    extreme += divisions == 0 || smallestPValue(first, second) <= data * (1 + 1e-9) ? 1 : 0;
    ++divisions;
  } while (std::next_permutation(isInB.begin(), isInB.end()));
  return double{1} * extreme / divisions;
}

// The larger fraction of both kinds of divisions.
double enumeratedPValue(const Rows& a, const Rows& b) {
  const double data = smallestWelch(a, b);
  const Standardised rows = standardised(a, b);
  return std::max(enumeratedPValue(a, b, data, smallestWelch),
                  enumeratedPValue(rows.a, rows.b, data, [&](const Rows& first, const Rows& second) {
                    return smallestStandardised(first, second, rows);
                  }));
}

TEST_CASE("groups that do not overlap have the smallest p-value, the fraction of their division and its mirror image") {
  // 20 divisions of 3 and 3, 70 of 4 and 4, 10 of 2 and 3: the latter has no mirror image.
  const PermutationTest six = testGroups(column({1, 2, 3}), column({5, 6, 7}), planFor(1));
  CHECK(six.pValue == Approx(2.0 / 20));
  CHECK(six.divisions == 10);
  CHECK(six.isExhaustive);
  CHECK(six.t[0] == Approx(4 / std::sqrt(2.0 / 3)));
  CHECK(testGroups(column({1, 2, 3, 4}), column({9, 8, 7, 6}), planFor(1)).pValue == Approx(2.0 / 70));
  CHECK(testGroups(column({1, 2}), column({9, 8, 8.5}), planFor(1)).pValue == Approx(1.0 / 10));
  CHECK(testGroups(column({9, 8, 8.5}), column({1, 2}), planFor(1)).pValue == Approx(1.0 / 10));
  CHECK(testGroups(column({1, 2}), column({9, 8, 8.5}), planFor(1)).minPValue == Approx(1.0 / 10));
}

TEST_CASE("a single row is compared with the spread of the other group, and two single rows with nothing") {
  std::vector<double> others;
  for (int i = 0; i < 19; ++i) others.push_back(0.1 * i);
  const PermutationTest far = testGroups(column({50}), column(others), planFor(1));
  CHECK(far.pValue == Approx(1.0 / 20));
  CHECK(far.minPValue == Approx(1.0 / 20));
  CHECK(far.t[0] == Approx((50 - 0.9) / std::sqrt(0.01 * (19 * 20 / 12.0) * (1 + 1 / 19.0))));
  CHECK(testGroups(column({0.9}), column(others), planFor(1)).pValue == 1);
  const PermutationTest two = testGroups(column({1}), column({2}), planFor(1));
  CHECK(two.pValue == 1);
  CHECK(two.minPValue == 1);
  CHECK(two.pValues == std::vector<double>{1});
}

TEST_CASE("p-values are those of a complete enumeration, for any sizes of the groups and one or more quantities") {
  std::mt19937 random(3);
  for (const auto& [countA, countB] : {std::pair{3, 4}, {4, 4}, {5, 3}, {2, 6}, {5, 5}}) {
    for (const std::size_t quantities : {std::size_t{1}, std::size_t{5}}) {
      for (const double noiseOfA : {1.0, 4.0}) {
        const Rows a = scaled(normalRows(random, static_cast<std::size_t>(countA), quantities, 1), noiseOfA);
        const Rows b = normalRows(random, static_cast<std::size_t>(countB), quantities);
        INFO(countA << " and " << countB << " rows of " << quantities << ", noise " << noiseOfA);
        CHECK(testGroups(a, b, planFor(quantities)).pValue == Approx(enumeratedPValue(a, b)));
      }
    }
  }
}

TEST_CASE("the tail probability of a quantity is that of Welch's test, to the accuracy of Wallace's approximation") {
  std::mt19937 random(4);
  for (const std::size_t countB : {std::size_t{6}, std::size_t{12}}) {
    const Rows a = normalRows(random, 6, 20, 0.5);
    Rows b = normalRows(random, countB, 20);
    for (auto& row : b) row[0] *= 10;
    const PermutationTest test = testGroups(a, b, planFor(20));
    for (std::size_t q = 0; q < 20; ++q) {
      const WelchTest exact = welch(summarise(valuesOf(a, q)), summarise(valuesOf(b, q)));
      CHECK(test.t[q] == Approx(exact.t));
      CHECK(test.tails[q] == Approx(exact.pValue).epsilon(0.05));
    }
  }
}

TEST_CASE("the signs of pairs are exchanged: of n differences of one sign, the p-value is 2 / 2^n") {
  CHECK(testPairs(column({1, 2, 3, 4, 5}), planFor(1)).pValue == Approx(2.0 / 32));
  CHECK(testPairs(column({-1, -2, -3, -4, -5}), planFor(1)).minPValue == Approx(2.0 / 32));
  // Four of the 16 signs of 1, 2, 3, 4 have a sum of at least 8: + + + + (10), - + + + (8), and both negated.
  CHECK(testPairs(column({-1, 2, 3, 4}), planFor(1)).pValue == Approx(4.0 / 16));
  CHECK(testPairs(column({-1, 2, 3, 4}), planFor(1)).t[0] == Approx(2 / std::sqrt((30 - 64.0 / 4) / 3 / 4)));
  CHECK(testPairs(column({1}), planFor(1)).pValue == 1);
  CHECK(testPairs(column({0, 0, 0, 0, 0}), planFor(1)).pValue == 1);
}

TEST_CASE("random divisions estimate the p-value of all divisions, the same with any number of threads") {
  std::mt19937 random(5);
  const Rows a = normalRows(random, 10, 3, 0.7), b = normalRows(random, 10, 3);
  PermutationPlan plan = planFor(3, 1e-5);
  const PermutationTest exact = testGroups(a, b, plan);
  CHECK(exact.isExhaustive);
  CHECK(exact.divisions == 92378);  // 20! / 10!^2 / 2
  plan.alpha = 0.05;
  const PermutationTest estimate = testGroups(a, b, plan);
  CHECK_FALSE(estimate.isExhaustive);
  CHECK(estimate.divisions == 10000);
  const double error = std::sqrt(exact.pValue * (1 - exact.pValue) / 10000);
  CHECK(std::abs(estimate.pValue - exact.pValue) < 4 * error + 1e-4);
  CHECK(estimate.pValue != exact.pValue);
  plan.threads = 3;
  CHECK(testGroups(a, b, plan).pValue == estimate.pValue);

  const Rows differences = normalRows(random, 18, 3, 0.5);
  plan.alpha = 1e-5;
  const PermutationTest exactPairs = testPairs(differences, plan);
  CHECK(exactPairs.divisions == 131072);
  plan.alpha = 0.05;
  CHECK(testPairs(differences, plan).pValue == Approx(exactPairs.pValue).epsilon(0.5).margin(1e-3));
}

TEST_CASE("a difference up to the margin does not count, and one without variance is beyond any doubt") {
  PermutationPlan plan = planFor(1);
  const Rows ones = column({1, 1, 1, 1}), more = column({1.01, 1.01, 1.01, 1.01});
  CHECK(testGroups(ones, ones, plan).pValue == 1);
  const PermutationTest differ = testGroups(ones, more, plan);
  CHECK(differ.pValue == Approx(2.0 / 70));
  CHECK(differ.t[0] > 1e6);
  plan.margins = {0.02};
  CHECK(testGroups(ones, more, plan).pValue == 1);
  CHECK(testPairs(column({0.01, 0.011, 0.012, 0.01, 0.01}), plan).pValue == 1);
  plan.margins = {0};
  CHECK(testPairs(column({0.01, 0.011, 0.012, 0.01, 0.01}), plan).pValue == Approx(2.0 / 32));
}

TEST_CASE("p-values of quantities are adjusted for all of them, and the smallest is that of the test") {
  std::mt19937 random(11);
  Rows a = normalRows(random, 7, 50);
  const Rows b = normalRows(random, 7, 50);
  for (auto& row : a) row[20] += 20;
  const PermutationTest test = testGroups(a, b, planFor(50, 0.01));
  CHECK(test.pValue == test.minPValue);
  CHECK(test.pValues[20] == test.pValue);
  CHECK(*std::min_element(test.pValues.begin(), test.pValues.begin() + 20) > 0.01);
}

TEST_CASE("a family of one quantity is not hidden by a large family") {
  std::mt19937 random(13);
  int together = 0, apart = 0;
  for (int run = 0; run < 100; ++run) {
    Rows a = normalRows(random, 7, 401);
    const Rows b = normalRows(random, 7, 401);
    for (auto& row : a) row[0] += 2.4;
    PermutationPlan plan = planFor(401);
    together += testGroups(a, b, plan).pValue <= 0.05 ? 1 : 0;
    plan.families = {1, 400};
    apart += testGroups(a, b, plan).pValue <= 0.05 ? 1 : 0;
  }
  CHECK(apart > together + 20);
  CHECK(apart > 80);
}

TEST_CASE("the test is significant if and only if a quantity is beyond the critical probability of its family") {
  std::mt19937 random(17);
  int significant = 0;
  for (int run = 0; run < 200; ++run) {
    const Rows a = normalRows(random, 5, 12, run % 2 == 0 ? 0 : 1), b = normalRows(random, 6, 12);
    PermutationPlan plan = planFor(12);
    plan.families = {2, 10};
    const PermutationTest test = testGroups(a, b, plan);
    REQUIRE(test.criticalTails.size() == 2);
    bool exceeds = false;
    for (std::size_t q = 0; q < 12; ++q)
      exceeds = exceeds || test.tails[q] < test.criticalTails[q < 2 ? 0 : 1] * (1 - 1e-9);
    CHECK(exceeds == (test.pValue <= 0.05));
    significant += exceeds ? 1 : 0;
  }
  CHECK(significant > 20);
  CHECK(significant < 180);
  CHECK(testGroups(column({1, 2}), column({3, 4}), planFor(1)).criticalTails[0] == 0);
}

TEST_CASE("groups of equal means give no more alarms than the level, and few less, if one has more noise") {
  std::mt19937 random(23);
  constexpr int kRuns = 300;
  for (const auto& [countA, countB, noiseOfA] :
       {std::tuple{6, 6, 1.0}, {5, 9, 4.0}, {5, 9, 0.25}, {6, 6, 10.0}, {3, 12, 2.0}}) {
    int alarms = 0;
    for (int run = 0; run < kRuns; ++run) {
      const Rows a = scaled(normalRows(random, static_cast<std::size_t>(countA), 12), noiseOfA);
      const Rows b = normalRows(random, static_cast<std::size_t>(countB), 12);
      alarms += testGroups(a, b, planFor(12)).pValue <= 0.05 ? 1 : 0;
    }
    INFO(countA << " and " << countB << " rows, noise " << noiseOfA << ": " << alarms << " alarms");
    CHECK(binomialTail(static_cast<std::uint64_t>(alarms), kRuns, 0.05) > 0.01);
    CHECK(alarms > 5);
  }
}

TEST_CASE("a difference far beyond the noise is found, if the smaller group has more of it") {
  std::mt19937 random(29);
  for (int run = 0; run < 20; ++run) {
    const Rows a = scaled(normalRows(random, 6, 20, 10), 10), b = normalRows(random, 18, 20);
    CHECK(testGroups(a, b, planFor(20)).pValue < 0.001);
  }
}

TEST_CASE("a quantity that varies in one group only is tested by the noise of this group") {
  // The mean of B is 3 standard errors from 1. With less noise in B, it is beyond doubt.
  const Rows ones = column({1, 1, 1, 1, 1, 1}), near = column({1.2, 1.9, 1.6, 1.3, 1.0, 1.1});
  const PermutationTest test = testGroups(ones, near, planFor(1));
  CHECK(test.t[0] == Approx(0.35 / std::sqrt(0.115 / 6)));
  CHECK(test.pValue > 0.02);
  CHECK(test.pValue < 0.2);
  CHECK(testGroups(ones, column({1.2, 1.21, 1.22, 1.23, 1.24, 1.25}), planFor(1)).pValue == Approx(2.0 / 924));
}

// A value that is common to all quantities of a row makes them dependent; Cauchy's distribution has no mean. The
// outliers of one group look like more noise, so that the test is stricter than the level.
TEST_CASE("equal groups give no more alarms than the level, for dependent quantities with heavy tails") {
  std::mt19937 random(19);
  std::cauchy_distribution<double> cauchy;
  std::normal_distribution<double> normal;
  constexpr int kRuns = 500;
  int alarms = 0;
  const auto rowsOf = [&](std::size_t count) {
    Rows rows(count, std::vector<double>(30));
    for (auto& row : rows) {
      const double common = cauchy(random);
      for (double& value : row) value = common + normal(random);
    }
    return rows;
  };
  for (int run = 0; run < kRuns; ++run) alarms += testGroups(rowsOf(5), rowsOf(4), planFor(30)).pValue <= 0.05 ? 1 : 0;
  CHECK(binomialTail(static_cast<std::uint64_t>(alarms), kRuns, 0.05) > 0.01);
}

}  // namespace
}  // namespace candela::statistics
