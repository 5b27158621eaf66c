// Warps and their densities: a million random points, inverted to the unit square by the test's own formulas, are
// uniform there.
#include <catch2/catch.hpp>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/chi_square.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/proof/numbers.h"

using namespace candela::proof;

namespace {

constexpr std::size_t kWarpSamples = 1000000;
constexpr int kWarpSide = 32;

// `unwarp` returns the point of the unit square to which a value belongs.
template <class Value, class Unwarp>
void checkUniform(const std::vector<Value>& values, const Unwarp& unwarp) {
  Cells cells(kWarpSide, kWarpSide);
  for (const Value& value : values) cells.add(unwarp(value));
  checkCounts(cells.counts(), uniformCounts(kWarpSide, kWarpSide, kWarpSamples));
}

// By its distribution function, 1 - (1 - x)^2 / 2 above 0.
double unwarpTent(double x) { return x < 0 ? (1 + x) * (1 + x) / 2 : 1 - (1 - x) * (1 - x) / 2; }

// The integral of exp(-x^2 / 2) - exp(-8) from 0.
double gaussianIntegral(double x) {
  return std::sqrt(std::numbers::pi / 2) * std::erf(x / std::sqrt(2.0)) - x * std::exp(-8.0);
}
double unwarpGaussian(double x) { return 0.5 + gaussianIntegral(x) / (2 * gaussianIntegral(4)); }

// With s = b1 + b2, s^2 and b2 / s are independent and uniform.
dvec2 unwarpTriangle(const dvec2& b) {
  const double s = b.x + b.y;
  return {s * s, s == 0 ? 0 : b.y / s};
}

}  // namespace

TEST_CASE("the warps to disc, cosine hemisphere, triangle and tent have their densities") {
  const WarpValues values = warps(randomNumbers(kWarpSamples, 101), 1);
  checkUniform(values.disc, [](const dvec2& p) { return dvec2(dot(p, p), turns(p.x, p.y)); });
  // The fraction of a cosine hemisphere within the angle theta is sin^2 theta.
  checkUniform(values.cosineHemisphere, [](const dvec3& w) { return dvec2(1 - w.z * w.z, turns(w.x, w.y)); });
  checkUniform(values.triangle, unwarpTriangle);
  Cells heights(kWarpSide * kWarpSide, 1);
  for (const double x : values.tent) heights.add({unwarpTent(x), 0});
  checkCounts(heights.counts(), uniformCounts(kWarpSide * kWarpSide, 1, kWarpSamples));
}

TEST_CASE("the warp to a Gaussian that ends at 4 has its density and its moments") {
  const WarpValues values = warps(randomNumbers(kWarpSamples, 103), 1);
  Cells heights(kWarpSide * kWarpSide, 1);
  double mean = 0, meanSquare = 0, farthest = 0;
  for (const double x : values.gaussian) {
    heights.add({unwarpGaussian(x), 0});
    mean += x / kWarpSamples;
    meanSquare += x * x / kWarpSamples;
    farthest = std::max(farthest, std::abs(x));
  }
  checkCounts(heights.counts(), uniformCounts(kWarpSide * kWarpSide, 1, kWarpSamples));
  // The integrals of x^2 exp(-x^2 / 2) and of x^2 exp(-8) from 0 to 4, by parts.
  const double edge = std::exp(-8.0);
  const double square = gaussianIntegral(4) - 64.0 / 3 * edge;
  const double variance = square / gaussianIntegral(4);
  CHECK(variance == Approx(0.994283).epsilon(1e-5));
  const double error = 1 / std::sqrt(double{kWarpSamples});
  CHECK(mean == Approx(0).margin(4 * error));
  CHECK(meanSquare == Approx(variance).margin(4 * std::sqrt(2.0) * error));
  CHECK(farthest <= 4);
  CHECK(farthest > 3.9);
}

TEST_CASE("the warps to caps from a thousandth of the hemisphere to the whole sphere give uniform unit vectors") {
  for (const float height : {1e-3f, 0.3f, 1.0f, 2.0f}) {
    CAPTURE(height);
    const WarpValues values = warps(randomNumbers(kWarpSamples, 102), height);
    checkUniform(values.cap, [&](const dvec3& w) {
      // Narrow caps are inverted by the distance from the axis, which is accurate there, and wide ones by z.
      const double across = w.x * w.x + w.y * w.y;
      const double fromTop = w.z > 0.5 ? across / (1 + w.z) : 1 - w.z;
      return dvec2(fromTop / height, turns(w.x, w.y));
    });
    double longest = 0;
    for (const dvec3& w : values.cap) longest = std::max(longest, std::abs(length(w) - 1));
    CHECK(longest < kRounding);
  }
}
