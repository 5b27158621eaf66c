// Shapes and area lights of Mitsuba, whose pixels have values of a closed form, or of an integral over one variable.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/scene/mitsuba/mitsuba_scenes.h"

namespace candela::mitsuba {
namespace {

using glm::dvec3;

/// The mean of a function over [0, 1].
template <class Function>
double meanOf(const Function& function) {
  constexpr int kSteps = 100000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += function((i + 0.5) / kSteps);
  return sum / kSteps;
}

}  // namespace

// The light shines along the view, so that a white surface has the radiance of the cosine between its normal and both.
// It is sqrt((1 - u)/(1 + 3u)) for a sphere whose depth is stretched by 2, at the distance sqrt(u) from the axis, and
// the same for a cylinder at u = x^2. A ball and a disk cover the fraction pi/4 of a pixel.
TEST_CASE("Round shapes of Mitsuba, exact ones and meshes, have the pictures of the exact shapes") {
  const double quarter = std::numbers::pi / 4;
  const auto stretched = [](double u) { return std::sqrt((1 - u) / (1 + 3 * u)); };
  const double ellipsoid = quarter * meanOf(stretched), tube = meanOf([&](double x) { return stretched(x * x); });
  checkRow("round_shapes.xml",
           {dvec3(quarter * 2 / 3), dvec3(ellipsoid), dvec3(quarter), dvec3(tube), dvec3(quarter), dvec3(1)}, {}, 5e-4);
}

// A roof of 45 degrees is smooth or flat. The colours of a texture of two by two texels show which row is the first.
TEST_CASE("Meshes of Mitsuba have smooth normals, texture coordinates and fronts as their options say") {
  const double half = std::sqrt(0.5);
  const double smooth = meanOf([&](double t) {
    const double x = (1 - t) * half, z = (1 - t) * half + t;
    return z / std::sqrt(x * x + z * z);
  });
  checkRow("mesh_options.xml",
           {dvec3(smooth), dvec3(half), dvec3(0.75), dvec3(0.25), dvec3(0.25), dvec3(0.75), dvec3(0), dvec3(0.5)});
}

// Below the centre of a light at the distance 3, by the solid angle that the cosine weighs: a disk of radius 2 has 4/13
// of pi, a sphere of radius 1 a ninth, and a square of side 4 four corners of configuration factors.
TEST_CASE("Area lights of Mitsuba illuminate what is before them, and nothing behind them") {
  const dvec3 radiance(1, 2, 4);
  const double a = 2.0 / 3, root = std::sqrt(1 + a * a);
  const double corner = 1 / std::numbers::pi * a / root * std::atan(a / root);
  checkRow("area_lights.xml", {4.0 / 13 * radiance}, {"disk"}, 2e-3);
  checkRow("area_lights.xml", {1.0 / 9 * radiance}, {"sphere"}, 2e-3);
  checkRow("area_lights.xml", {4 * corner * radiance}, {"square"}, 2e-3);
  checkRow("area_lights.xml", {dvec3(0)}, {"back"});
}

}  // namespace candela::mitsuba
