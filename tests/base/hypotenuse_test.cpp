// The length of a vector in a plane: its error, its limits, and its bits.
#include "host/base/hypotenuse.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cstdint>
#include <random>

#include "host/base/hash.h"

using namespace candela;

namespace {

// A number between -1 and 1 whose magnitude is often small.
double number(std::mt19937_64& random) {
  const double fraction = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
  return std::ldexp(fraction, -static_cast<int>(random() % 40));
}

}  // namespace

TEST_CASE("a hypotenuse has an error of at most 0.6 ulp") {
  std::mt19937_64 random(1);
  long double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const long double a = number(random), b = number(random);
    const double found = hypotenuse(static_cast<double>(a), static_cast<double>(b));
    worst = std::max(worst, std::abs(found - std::sqrt(a * a + b * b)) / (std::nextafter(found, 2.0) - found));
  }
  CHECK(worst < 0.6L);
}

TEST_CASE("a hypotenuse is exact for zero, for triples, and where squares underflow") {
  CHECK(hypotenuse(0, 0) == 0);
  CHECK(hypotenuse(-3, 4) == 5);
  CHECK(hypotenuse(0, -0x1p-1074) == 0x1p-1074);
  CHECK(hypotenuse(3e-200, 4e-200) == 5e-200);
  CHECK(hypotenuse(0x3p-560, -0x4p-560) == 0x5p-560);
  CHECK(hypotenuse(0x3p500, 0x4p500) == 0x5p500);
}

TEST_CASE("the bits of hypotenuses are the same on every processor") {
  std::mt19937_64 random(2);
  std::uint64_t hash = 0;
  for (int i = 0; i < 100000; ++i) {
    const double a = number(random), b = number(random);
    hash = splitMix(hash ^ std::bit_cast<std::uint64_t>(hypotenuse(a, b)));
  }
  CHECK(hash == 0xb9adb41cc2f20cd9u);
}
