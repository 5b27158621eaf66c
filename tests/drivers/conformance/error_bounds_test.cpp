// Intervals of the results that Vulkan permits, by values calculated by hand.
#include "host/drivers/conformance/error_bounds.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace candela::conformance {

TEST_CASE("a unit in the last place is the distance of floats") {
  CHECK(unitInLastPlace(1) == 0x1p-23);
  CHECK(unitInLastPlace(1.999) == 0x1p-23);
  CHECK(unitInLastPlace(-2) == 0x1p-22);
  CHECK(unitInLastPlace(0) == 0x1p-149);
}

TEST_CASE("a correctly rounded result is one of two floats, or exact") {
  CHECK(correctlyRounded(1.5).low == 1.5);
  CHECK(correctlyRounded(1.5).high == 1.5);
  const Interval third = correctlyRounded(1.0 / 3);
  CHECK(third.contains(static_cast<double>(1.0f / 3)));
  CHECK(third.high - third.low == 0x1p-25);
  CHECK_FALSE(third.contains(static_cast<double>(std::nextafter(std::nextafter(1.0f / 3, 1.0f), 1.0f))));
  CHECK(correctlyRounded(-1.0 / 3).low == -third.high);
}

TEST_CASE("bounds of functions contain correct results, and exclude others a few units away") {
  for (const double x : {0x1p-20, 0.3, 1.0, 1.7, 12345.0}) {
    CAPTURE(x);
    CHECK(boundOfSqrt(x).contains(std::sqrt(x)));
    CHECK_FALSE(boundOfSqrt(x).contains(std::sqrt(x) * (1 + 8 * 0x1p-23)));
    CHECK_FALSE(boundOfSqrt(x).contains(std::sqrt(x) * (1 - 8 * 0x1p-23)));
    CHECK(boundOfLog2(x).contains(std::log2(x)));
    CHECK_FALSE(boundOfLog2(x).contains(std::log2(x) + 1e-5));
    CHECK(boundOfPow(x, 1.25).contains(std::pow(x, 1.25)));
    CHECK(boundOfPow(x, -1.25).contains(std::pow(x, -1.25)));
    CHECK_FALSE(boundOfPow(x, 1.25).contains(1.0001 * std::pow(x, 1.25)));
  }
  CHECK(boundOfExp2({3, 3}).contains(8));
  CHECK(boundOfExp2({3, 3}).high == Approx(8 + 9 * 0x1p-20));
  CHECK(withinError(1, 0.5).contains(1.5));
  CHECK_FALSE(withinError(1, 0.5).contains(std::nan("")));
}

}  // namespace candela::conformance
