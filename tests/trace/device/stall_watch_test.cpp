// A device stalls if no state of a path changes for many sweeps.
#include "host/trace/device/stall_watch.h"

#include <catch2/catch.hpp>

using namespace candela::device;

namespace {

constexpr std::uint64_t kSweeps = StallWatch::kSweeps;

}  // namespace

TEST_CASE("states are compared only after many sweeps without a finished sample") {
  StallWatch watch;
  for (std::uint64_t sweep = 0; sweep < 1000; ++sweep) CHECK_FALSE(watch.mustCompare(sweep % kSweeps == 3, sweep));
  CHECK_FALSE(watch.mustCompare(1, 2000));
  CHECK_FALSE(watch.mustCompare(0, 2000 + kSweeps - 1));
  CHECK(watch.mustCompare(0, 2000 + kSweeps));
  CHECK_FALSE(watch.mustCompare(0, 2000 + kSweeps + 1));
  CHECK(watch.mustCompare(0, 2000 + 2 * kSweeps));
}

TEST_CASE("a device stalls if the states are those of the last comparison") {
  StallWatch watch;
  CHECK_FALSE(watch.isStalled(0));
  CHECK_FALSE(watch.isStalled(7));
  CHECK(watch.isStalled(7));
}

TEST_CASE("a sample that finishes discards the last comparison") {
  StallWatch watch;
  CHECK_FALSE(watch.isStalled(7));
  CHECK_FALSE(watch.mustCompare(1, 5));
  CHECK_FALSE(watch.isStalled(7));
}
