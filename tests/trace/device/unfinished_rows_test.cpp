// The estimate of unfinished pixels is accurate enough to size the next dispatch.
#include "host/trace/device/unfinished_rows.h"

#include <catch2/catch.hpp>

using namespace candela;
using namespace candela::device;

TEST_CASE("every pixel has work left at first") {
  const UnfinishedRows rows(100, std::vector<std::uint32_t>(50, 100));
  CHECK(rows.activeIn({0, 0, 100, 50}) == 5000);
  CHECK(rows.activeIn({20, 10, 30, 2}) == 60);
  CHECK(rows.pixelsHolding(1000, 0) == 1000);
}

TEST_CASE("a region extends over finished rows until it contains enough unfinished pixels") {
  UnfinishedRows rows(100, std::vector<std::uint32_t>(50, 100));
  rows.finish({0, 0, 100, 20}, 2000);
  CHECK(rows.activeIn({0, 0, 100, 20}) == 1);
  CHECK(rows.activeIn({0, 10, 100, 20}) == 1000);
  CHECK(rows.pixelsHolding(1000, 0) == 3000);
}

TEST_CASE("a region is never smaller than requested, and ends with the band") {
  UnfinishedRows rows(100, std::vector<std::uint32_t>(50, 100));
  rows.finish({0, 0, 100, 50}, 4000);
  CHECK(rows.activeIn({0, 0, 100, 50}) == Approx(1000).margin(1));
  CHECK(rows.pixelsHolding(400, 0) == Approx(2000).margin(100));
  CHECK(rows.pixelsHolding(5000, 40) == 5000);
}
