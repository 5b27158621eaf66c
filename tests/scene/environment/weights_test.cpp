// The integer weights of texels: exact in their sum, in proportion to luminance times solid angle.
#include "host/scene/environment/weights.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "host/image/film.h"

using namespace candela;
using namespace candela::environment;

namespace {

scene::Environment mapOf(std::uint32_t width, std::uint32_t height, std::uint32_t seed, double contrast,
                         bool hasRowsAtPoles = false) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-contrast, contrast);
  scene::Environment environment{.name = "", .width = width, .height = height, .texels = {}, .weights = {}};
  for (std::uint32_t i = 0; i < width * height; ++i) environment.texels.emplace_back(std::exp2(exponent(random)), 1, 2);
  environment.hasRowsAtPoles = hasRowsAtPoles;
  setWeights(environment);
  return environment;
}

}  // namespace

TEST_CASE("the weights of a map sum to 2^24 times its texels") {
  for (const double contrast : {0.0, 3.0, 40.0}) {
    const scene::Environment map = mapOf(37, 19, 1, contrast);
    const auto sum = std::accumulate(map.weights.begin(), map.weights.end(), std::uint64_t{0});
    CHECK(sum == std::uint64_t{37 * 19} << 24);
  }
}

TEST_CASE("weights are in proportion to luminance times the solid angle of the texel") {
  const bool hasRowsAtPoles = GENERATE(false, true);
  const scene::Environment map = mapOf(16, 9, 2, 2, hasRowsAtPoles);
  const auto latitudeAt = [&](double t) {
    return std::numbers::pi * (0.5 - (hasRowsAtPoles ? std::clamp((t - 0.5) / 8, 0.0, 1.0) : t / 9));
  };
  double total = 0;
  std::vector<double> expected;
  for (std::size_t i = 0; i < map.texels.size(); ++i) {
    const auto row = static_cast<double>(i / 16);
    const double solidAngle = (std::sin(latitudeAt(row)) - std::sin(latitudeAt(row + 1))) * 2 * std::numbers::pi / 16;
    expected.push_back(image::luminance(glm::dvec3(map.texels[i])) * solidAngle);
    total += expected.back();
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double unit = expected[i] / total * 16 * 9 * 0x1p24;
    CAPTURE(i);
    CHECK(std::abs(static_cast<double>(map.weights[i]) - unit) <= 1.001);
  }
}

TEST_CASE("a black map has no weights, and one bright texel has all") {
  scene::Environment map{
      .name = "", .width = 4, .height = 2, .texels = std::vector<glm::vec3>(8, glm::vec3(0)), .weights = {}};
  setWeights(map);
  CHECK(map.weights == std::vector<std::uint64_t>(8, 0));
  map.texels[5] = {0, 1e-20f, 0};
  setWeights(map);
  CHECK(map.weights[5] == std::uint64_t{8} << 24);
}
