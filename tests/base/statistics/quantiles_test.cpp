// Medians, percentiles and spreads of values by numbers calculated by hand.
#include "host/base/statistics/quantiles.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace candela::statistics {
namespace {

TEST_CASE("the median is the middle value, or the mean of the two middle ones") {
  CHECK(median({}) == 0);
  CHECK(median(std::vector{3.0}) == 3);
  CHECK(median(std::vector{1.0, 2.0, 9.0}) == 2);
  CHECK(median(std::vector{1.0, 2.0, 4.0, 9.0}) == 3);
  CHECK(spread(std::vector{1.0, 2.0, 4.0}) == 1.5);
  CHECK(spread({}) == 0);
}

TEST_CASE("a percentile is a value of the list, by nearest rank") {
  const std::vector<double> four{1, 2, 4, 9};
  CHECK(percentile(four, 0) == 1);
  CHECK(percentile(four, 0.5) == 2);
  CHECK(percentile(four, 0.51) == 4);
  CHECK(percentile(four, 1) == 9);
  CHECK(percentile({}, 0.5) == 0);
}

TEST_CASE("durations in any order are reported in seconds") {
  std::vector<double> seconds;
  for (int i = 100; i > 0; --i) seconds.push_back(i);
  CHECK(
      durationsJson(seconds) ==
      nlohmann::ordered_json{
          {"count", 100}, {"medianSeconds", 50.5}, {"p90Seconds", 90.0}, {"p99Seconds", 99.0}, {"maxSeconds", 100.0}});
  CHECK(durationsJson({})["medianSeconds"] == 0);
}

}  // namespace
}  // namespace candela::statistics
