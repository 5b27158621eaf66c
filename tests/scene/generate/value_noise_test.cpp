// Value noise: bounded, smooth, and the same on every machine.
#include "host/scene/generate/value_noise.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace candela::generate {

TEST_CASE("value noise is between 0 and 1 and approaches both") {
  double least = 1;
  double greatest = 0;
  for (int i = 0; i < 20000; ++i) {
    const double value = valueNoise({0.37 * i, -0.11 * i, 0.73 * i}, 1);
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  CHECK(least >= 0);
  CHECK(greatest < 1);
  CHECK(least < 0.05);
  CHECK(greatest > 0.95);
}

TEST_CASE("value noise has no steps, even at the borders of cells") {
  constexpr double kStep = 1e-6;
  constexpr double kSteepest = 1.5;  // of smoothstep, between values at most 1 apart
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 point(i * 0.125 - 100, i * 0.25, i * 0.375);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 before = point;
      glm::dvec3 after = point;
      before[axis] -= kStep;
      after[axis] += kStep;
      REQUIRE(std::abs(valueNoise(after, 2) - valueNoise(before, 2)) <= 2.001 * kStep * kSteepest);
    }
  }
}

TEST_CASE("value noise depends on the seed, on all coordinates and on their signs") {
  const glm::dvec3 point(3, 5, 7);
  const double value = valueNoise(point, 4);
  CHECK(valueNoise(point, 5) != value);
  for (const glm::dvec3& other : {glm::dvec3(4, 5, 7), {3, 4, 7}, {3, 5, 8}, {5, 3, 7}, {-3, 5, 7}}) {
    CHECK(valueNoise(other, 4) != value);
  }
}

TEST_CASE("one octave is value noise, and each further one weighs half") {
  const glm::dvec3 point(0.3, 1.7, -2.2);
  CHECK(fractalNoise(point, 1) == valueNoise(point, 0));
  const double two = (valueNoise(point, 0) + valueNoise(point * 2.0, 1) / 2) / 1.5;
  CHECK(fractalNoise(point, 2) == Approx(two).epsilon(1e-14));
}

TEST_CASE("value noise has the same values on every machine") {
  // At points with integer coordinates it is their hash, here from the published steps in Python.
  CHECK(valueNoise({0, 0, 0}, 0) * 0x1p32 == 1106484830);
  CHECK(valueNoise({1, 2, 3}, 4) * 0x1p32 == 1344842425);
  CHECK(valueNoise({-1, -2, -3}, 5) * 0x1p32 == 914991992);
}

}  // namespace candela::generate
