// Computes Pearson's statistic over cells of sufficient expected counts.
#include "tests/trace/proof/chi_square.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "host/base/statistics/error_rates.h"

namespace candela::proof {
namespace {

constexpr double kSuiteAlpha = 1e-3;
constexpr std::uint64_t kChecksOfSuite = 64;  // maximum number of checks on one side

struct Pool {
  double observed = 0;
  double expected = 0;
};

std::vector<Pool> poolCells(std::span<const double> observed, std::span<const double> expected) {
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  std::vector<Pool> pools;
  Pool open;
  for (const std::size_t cell : order) {
    open.observed += observed[cell];
    open.expected += expected[cell];
    if (open.expected < kLeastExpected) continue;
    pools.push_back(open);
    open = {};
  }
  if (pools.empty()) return {open};
  pools.back().observed += open.observed;  // of cells of which all together are too few
  pools.back().expected += open.expected;
  return pools;
}

bool countsTheImpossible(std::span<const double> observed, std::span<const double> expected) {
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (observed[i] > 0 && expected[i] == 0) return true;
  }
  return false;
}

}  // namespace

ChiSquareTest chiSquare(std::span<const double> observed, std::span<const double> expected) {
  if (countsTheImpossible(observed, expected)) return {.pValue = 0};
  const std::vector<Pool> pools = poolCells(observed, expected);
  ChiSquareTest test;
  test.degreesOfFreedom = pools.size() - 1;
  if (test.degreesOfFreedom == 0) return test;
  for (const Pool& pool : pools) {
    test.statistic += (pool.observed - pool.expected) * (pool.observed - pool.expected) / pool.expected;
  }
  const boost::math::chi_squared distribution(static_cast<double>(test.degreesOfFreedom));
  test.pValue = boost::math::cdf(boost::math::complement(distribution, test.statistic));
  return test;
}

void checkCounts(std::span<const double> observed, std::span<const double> expected) {
  REQUIRE(observed.size() == expected.size());
  const double drawn = std::accumulate(observed.begin(), observed.end(), 0.0);
  REQUIRE(std::accumulate(expected.begin(), expected.end(), 0.0) == Approx(drawn).epsilon(1e-6));
  const ChiSquareTest test = chiSquare(observed, expected);
  CAPTURE(test.statistic, test.degreesOfFreedom);
  CHECK(test.degreesOfFreedom > 0);
  CHECK(test.pValue > statistics::sidakLevel(kSuiteAlpha, kChecksOfSuite));
}

}  // namespace candela::proof
