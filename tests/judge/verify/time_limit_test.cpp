// Numbers of samples that a time limit permits.
#include "host/judge/verify/time_limit.h"

#include <catch2/catch.hpp>

namespace candela::verify {

TEST_CASE("without a time limit, every look has the samples that it wants") {
  TimeLimit none(std::nullopt);
  CHECK(none.affordable(1e6, 1, 1000) == 1000);
}

TEST_CASE("a look ends within the time limit at the rate of the last look") {
  TimeLimit limit(60.0);
  CHECK(limit.affordable(5, 1, 4) == 4);         // 15 s for three samples
  CHECK(limit.affordable(15, 4, 100) == 12);     // 40 s for eight of 5 s each
  CHECK(limit.affordable(16, 12, 100) == 24);    // the samples took 2 s each, and 24 s are left
  CHECK(limit.affordable(22.5, 24, 100) == 24);  // 1.5 s are left, less than one sample takes
}

TEST_CASE("preparation takes time from the looks, but does not count as the time of their samples") {
  TimeLimit limit(60.0);
  limit.spend(40);
  CHECK(limit.affordable(5, 1, 100) == 4);  // 15 s for three samples
  TimeLimit none(std::nullopt);
  none.spend(40);
  CHECK(none.affordable(5, 1, 100) == 100);
}

TEST_CASE("a time limit permits whole steps only") {
  TimeLimit limit(10.0);
  CHECK(limit.affordable(4, 16, 64, 16) == 32);
  CHECK(limit.affordable(4, 32, 64, 16) == 32);
}

TEST_CASE("once the time is over, there is no further look, even if looks take no time that can be measured") {
  TimeLimit limit(0.0);
  CHECK(limit.affordable(0, 1, 2) == 1);
  TimeLimit late(1.0);
  CHECK(late.affordable(2, 1, 2) == 1);
}

}  // namespace candela::verify
