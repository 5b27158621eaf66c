// The daylight of --env sun: values computed by hand from the paper's formulas, and plausible light.
#include "host/scene/environment/sun_sky.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "host/base/errors.h"
#include "host/image/film.h"
#include "host/scene/environment/placement.h"
#include "host/scene/environment/preetham.h"

using namespace candela;
using namespace candela::environment;
using glm::dvec3;
using std::numbers::pi;

namespace {

constexpr double kDegree = pi / 180;

struct Light {
  dvec3 irradiance{0};  // of a horizontal surface, from above
  dvec3 sunwards{0};    // vector irradiance of everything much brighter than the sky
};

// By quadrature, of the bilinear interpolation that the tracers show: row coordinates above the pole, which are
// negative, are on its other side.
double solidAngleOfTexel(std::uint32_t row, const scene::Environment& map) {
  constexpr int kCount = 256;
  double sum = 0;
  for (int i = 0; i < kCount; ++i) {
    const double offset = 2 * (i + 0.5) / kCount - 1;
    sum += (1 - std::abs(offset)) * std::abs(std::sin(pi * (row + 0.5 + offset) / map.height));
  }
  return 2 * pi / map.width * pi / map.height * sum * 2 / kCount;
}

Light lightOf(const scene::Environment& map) {
  Light light;
  for (std::uint32_t row = 0; row < map.height / 2; ++row) {
    const double solidAngle = solidAngleOfTexel(row, map);
    for (std::uint32_t column = 0; column < map.width; ++column) {
      const dvec3 direction = directionOf(column + 0.5, row + 0.5, map.width, map.height);
      const dvec3 texel(map.texels[std::size_t{row} * map.width + column]);
      light.irradiance += direction.y * solidAngle * texel;
      if (texel.g > 50) light.sunwards += direction * solidAngle * texel.g;
    }
  }
  return light;
}

}  // namespace

TEST_CASE("the zenith of a sky has the luminance of the paper's formula") {
  // Turbidity 3, sun 60 degrees from the zenith: chi = (4/9 - 3/120) (pi - 2 pi / 3) = 0.4392329,
  // (4.0453 * 3 - 4.9710) tan(chi) - 0.2155 * 3 + 2.4192 = 7.1649 * 0.4697924 + 1.7727 = 5.1387.
  const PreethamSky sky({std::sin(60 * kDegree), std::cos(60 * kDegree), 0}, 3);
  CHECK(image::luminance(sky.sky({0, 1, 0})) == Approx(5.1387).epsilon(1e-3));
}

TEST_CASE("a sky is brightest around the sun and bluest away from it") {
  const dvec3 sun(std::sin(50 * kDegree), std::cos(50 * kDegree), 0);
  const PreethamSky sky(sun, 2.5);
  const dvec3 near = sky.sky(sun), away = sky.sky({-std::sin(40 * kDegree), std::cos(40 * kDegree), 0});
  CHECK(image::luminance(near) > 3 * image::luminance(away));
  CHECK(away.b > 1.3 * away.r);
}

TEST_CASE("the sun is attenuated as its path through the air is long, and red when it is low") {
  // Air mass 1 at the zenith: Rayleigh 0.008735 * 0.549^-4.08 = 0.1009, aerosol (0.04608 * 2 - 0.04586) * 0.549^-1.3 =
  // 0.1010.
  const PreethamSky high({0, 1, 0}, 2), low({std::cos(5 * kDegree), std::sin(5 * kDegree), 0}, 2);
  CHECK(high.sun().g == Approx(128 * std::exp(-0.2019)).epsilon(2e-3));
  CHECK(low.sun().g < high.sun().g / 4);
  CHECK(low.sun().r > 3 * low.sun().b);
}

TEST_CASE("the sun of a map is at its elevation, and its azimuth is a compass bearing from -z over +x") {
  const Light light = lightOf(makeSunSky("30,75,3"));
  const dvec3 expected(std::cos(30 * kDegree) * std::sin(75 * kDegree), std::sin(30 * kDegree),
                       -std::cos(30 * kDegree) * std::cos(75 * kDegree));
  CHECK(length(normalize(light.sunwards) - expected) < 1e-3);
}

TEST_CASE("a high sun in clear air illuminates the ground with about 100 klx, which is an irradiance of pi") {
  const Light light = lightOf(makeSunSky("60,0,2.5"));
  CHECK(image::luminance(light.irradiance) > 0.8 * pi);
  CHECK(image::luminance(light.irradiance) < 1.2 * pi);
}

TEST_CASE("the irradiance by the sun's disc is that of the model, whatever texels it covers") {
  for (const double elevation : {12.0, 44.87, 89.9, 90.0}) {
    const PreethamSky model({std::cos(elevation * kDegree), std::sin(elevation * kDegree), 0}, 2);
    const Light light = lightOf(makeSunSky(std::to_string(elevation) + ",90,2"));
    CAPTURE(elevation);
    CHECK(length(light.sunwards) * 100 / pi == Approx(model.sun().g).epsilon(0.01));
  }
}

TEST_CASE("the sun's disc is uniform, and its diameter is 0.533 degrees, as seen from the earth") {
  // The mean square of the distance from the centre of a uniform disc is half the square of its radius. Texels that are
  // d across add d^2 / 12 in each dimension (Sheppard's correction).
  constexpr double kRadius = 0.5 * 0.533 * kDegree, kElevation = 15 * kDegree;
  const scene::Environment map = makeSunSky("15,90,2");
  const dvec3 sun(std::cos(kElevation), std::sin(kElevation), 0);
  double light = 0, moment = 0;
  for (std::uint32_t row = 0; row < map.height / 2; ++row) {
    for (std::uint32_t column = 0; column < map.width; ++column) {
      const double texel = map.texels[std::size_t{row} * map.width + column].g;
      if (texel <= 50) continue;  // sky
      const dvec3 offset = directionOf(column + 0.5, row + 0.5, map.width, map.height) - sun;
      light += texel;
      moment += texel * dot(offset, offset);
    }
  }
  REQUIRE(light > 0);
  const double down = pi / map.height, across = std::cos(kElevation) * 2 * pi / map.width;
  const double expected = kRadius * kRadius / 2 + (down * down + across * across) / 12;
  CHECK(moment / light == Approx(expected).epsilon(0.05));
}

TEST_CASE("half of a sun at the horizon is seen, above ground of albedo 0.2") {
  const scene::Environment map = makeSunSky("25,0,4");
  const Light light = lightOf(map);
  const dvec3 ground(map.texels.back());
  CHECK(ground.g == Approx(0.2 / pi * light.irradiance.g).epsilon(1e-3));
  const PreethamSky model({1, 0, 0}, 2);
  CHECK(length(lightOf(makeSunSky("0,90,2")).sunwards) < 0.6 * pi / 100 * model.sun().g);
}

TEST_CASE("numbers of a sun that are missing, superfluous or out of range are refused") {
  for (const char* numbers : {"", "30", "30,10", "30,10,", "30,10,3,", "30,10,3,4", "x,10,3", "-1,10,3", "91,10,3",
                              "30,361,3", "30,10,1.9", "30,10,11", "nan,10,3", "30,10,3 "}) {
    CAPTURE(numbers);
    CHECK_THROWS_AS(makeSunSky(numbers), UsageError);
  }
}
