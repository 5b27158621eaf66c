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

// The fraction of all divisions whose smallest p-value is at most that of the data.
double enumeratedPValue(const Rows& a, const Rows& b) {
  const double data = smallestWelch(a, b);
  std::vector<bool> isInB(a.size() + b.size());
  std::fill(isInB.begin() + static_cast<std::ptrdiff_t>(a.size()), isInB.end(), true);
  int divisions = 0, extreme = 0;
  do {
    Rows first, second;
    for (std::size_t i = 0; i < isInB.size(); ++i) {
      (isInB[i] ? second : first).push_back(i < a.size() ? a[i] : b[i - a.size()]);
    }
    ++divisions;
    extreme += smallestWelch(first, second) <= data * (1 + 1e-9) ? 1 : 0;
  } while (std::next_permutation(isInB.begin(), isInB.end()));
  return double{1} * extreme / divisions;
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
      const Rows a = normalRows(random, static_cast<std::size_t>(countA), quantities, 1);
      const Rows b = normalRows(random, static_cast<std::size_t>(countB), quantities);
      INFO(countA << " and " << countB << " rows of " << quantities);
      CHECK(testGroups(a, b, planFor(quantities)).pValue == Approx(enumeratedPValue(a, b)));
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
  Rows a = normalRows(random, 8, 50);
  const Rows b = normalRows(random, 8, 50);
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
    Rows a = normalRows(random, 8, 401);
    const Rows b = normalRows(random, 8, 401);
    for (auto& row : a) row[0] += 2.2;
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

// A value that is common to all quantities of a row makes them dependent; Cauchy's distribution has no mean.
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
  CHECK(alarms > 10);
}

}  // namespace
}  // namespace candela::statistics
