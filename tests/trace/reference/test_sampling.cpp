// Warps and frames, compared with closed-form inverses and moments.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "host/trace/reference/sampling.h"

using namespace candela::reference;

namespace {

constexpr int kSide = 200;

// Mean of g over a regular grid of the unit square.
template <class T>
T meanOverSquare(const std::function<T(const dvec2&)>& g) {
  T sum(0);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) sum += g(dvec2((x + 0.5) / kSide, (y + 0.5) / kSide));
  }
  return sum / static_cast<double>(kSide * kSide);
}

// The inverse of Shirley and Chiu's map: the square of half side r around the origin becomes the circle of radius r.
dvec2 squareOfDisc(const dvec2& p) {
  const double r = length(p);
  if (r == 0) return {0.5, 0.5};
  const double phi = std::atan2(p.y, p.x);
  dvec2 ab;
  if (std::abs(p.x) > std::abs(p.y)) {
    ab = p.x > 0 ? dvec2(r, phi * 4 / kPi * r) : dvec2(-r, -r * std::remainder(phi - kPi, 2 * kPi) * 4 / kPi);
  } else {
    const double quarter = p.y > 0 ? phi - kPi / 2 : phi + kPi / 2;
    ab = p.y > 0 ? dvec2(-quarter * 4 / kPi * r, r) : dvec2(quarter * 4 / kPi * r, -r);
  }
  return (ab + 1.0) / 2.0;
}

}  // namespace

TEST_CASE("the disc warp is inverted by the map from circles to squares") {
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      const dvec2 u((x + 0.3) / 20, (y + 0.6) / 20);
      const dvec2 back = squareOfDisc(sampleDisc(u));
      INFO(u.x << " " << u.y << " came back as " << back.x << " " << back.y);
      CHECK(length(back - u) < 1e-12);
    }
  }
  CHECK(sampleDisc({0.5, 0.5}) == dvec2(0, 0));
}

TEST_CASE("the disc warp is uniform in area") {
  const auto squared = meanOverSquare<dvec2>([](const dvec2& u) { return sampleDisc(u) * sampleDisc(u); });
  CHECK(squared.x == Approx(0.25).epsilon(1e-4));  // the second moment of a unit disc
  CHECK(squared.y == Approx(0.25).epsilon(1e-4));
}

TEST_CASE("the cosine warp has the moments of a cosine density") {
  const auto mean = meanOverSquare<dvec3>([](const dvec2& u) { return sampleCosineHemisphere(u); });
  CHECK(mean.x == Approx(0).margin(1e-12));
  CHECK(mean.z == Approx(2.0 / 3).epsilon(5e-4));  // the midpoint rule at the edge of a square root
  const auto squared = meanOverSquare<double>([](const dvec2& u) { return std::pow(sampleCosineHemisphere(u).z, 2); });
  CHECK(squared == Approx(0.5).epsilon(1e-4));
}

TEST_CASE("the cap warp gives unit vectors, uniform in height") {
  for (const double height : {1e-6, 0.3, 1.0, 2.0}) {
    const auto moments = meanOverSquare<dvec3>([&](const dvec2& u) {
      const dvec3 w = sampleCap(u, height);
      REQUIRE(length(w) == Approx(1).epsilon(1e-12));
      const double below = (1 - w.z) / height;  // uniform on [0, 1]
      return dvec3(below, below * below, w.x);
    });
    CHECK(moments.x == Approx(1.0 / 2).epsilon(1e-4));
    CHECK(moments.y == Approx(1.0 / 3).epsilon(3e-4));
    CHECK(moments.z == Approx(0).margin(1e-12));
    CHECK(capPdf(height) * 2 * kPi * height == Approx(1));  // density times area of the cap
  }
}

TEST_CASE("the triangle warp is uniform in area") {
  // Barycentric coordinates of a uniform point: mean 1/3, mean square 1/6, mean product 1/12.
  const auto moments = meanOverSquare<dvec3>([](const dvec2& u) {
    const dvec2 b = sampleTriangle(u);
    REQUIRE(b.x >= 0);
    REQUIRE(b.y >= 0);
    REQUIRE(b.x + b.y <= 1);
    return dvec3(b.x, b.x * b.x, b.x * b.y);
  });
  CHECK(moments.x == Approx(1.0 / 3).epsilon(1e-4));
  CHECK(moments.y == Approx(1.0 / 6).epsilon(1e-4));
  CHECK(moments.z == Approx(1.0 / 12).epsilon(1e-4));
}

TEST_CASE("the tent warp inverts the tent's distribution function") {
  for (double u = 0; u < 1; u += 1.0 / 64) {
    const double x = sampleTent(u);
    const double area = x < 0 ? (1 + x) * (1 + x) / 2 : 1 - (1 - x) * (1 - x) / 2;
    CHECK(area == Approx(u).margin(1e-12));
  }
}

TEST_CASE("the Gaussian warp inverts the distribution function of a Gaussian that is lowered to 0 at its ends") {
  const double edge = std::exp(-8.0);
  const auto integral = [&](double x) { return std::sqrt(kPi / 2) * std::erf(x / std::sqrt(2.0)) - x * edge; };
  const auto below = [&](double x) { return 0.5 + integral(x) / (2 * integral(4)); };
  const auto check = [&](double u) {
    CAPTURE(u);
    const double x = sampleGaussian(u);
    CHECK(std::abs(x) <= 4);
    CHECK(below(x) == Approx(u).margin(1e-13));
  };
  for (double u = 0; u < 1; u += 1.0 / 256) check(u);
  for (double u = 0x1p-24; u < 1e-4; u *= 2) {
    check(u);
    check(1 - u);
    CHECK(sampleGaussian(1 - u) == -sampleGaussian(u));
  }
  CHECK(sampleGaussian(0) == -4);
  CHECK(sampleGaussian(0.5) == 0);
  CHECK(sampleGaussian(1) == 4);
}

TEST_CASE("a frame is orthonormal and right-handed around any direction") {
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      const double z = -1 + i * 0.1, phi = j * 0.314159, r = std::sqrt(std::max(0.0, 1 - z * z));
      const Frame frame(dvec3(r * std::cos(phi), r * std::sin(phi), z));
      CHECK(length(frame.tangent) == Approx(1).epsilon(1e-12));
      CHECK(dot(frame.tangent, frame.normal) == Approx(0).margin(1e-12));
      CHECK(length(cross(frame.tangent, frame.bitangent) - frame.normal) < 1e-12);
      const dvec3 v(0.1, -0.7, 0.4);
      CHECK(length(frame.toLocal(frame.toWorld(v)) - v) < 1e-12);
    }
  }
}

TEST_CASE("the tangents of a frame are those of docs/light-transport.md") {
  // n = (0.6, 0, 0.8): s = 1, a = -1/1.8, b = 0.
  const Frame up(dvec3(0.6, 0, 0.8));
  CHECK(length(up.tangent - dvec3(1 - 0.36 / 1.8, 0, -0.6)) < 1e-15);
  CHECK(up.bitangent == dvec3(0, 1, 0));
  // n = (0, 0.6, -0.8): s = -1, a = 1/1.8, b = 0.
  const Frame down(dvec3(0, 0.6, -0.8));
  CHECK(down.tangent == dvec3(1, 0, 0));
  CHECK(length(down.bitangent - dvec3(0, -1 + 0.36 / 1.8, -0.6)) < 1e-15);
}
