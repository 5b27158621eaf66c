// FLIP, compared with closed forms and with an independent implementation.
#include "host/image/flip.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "host/base/errors.h"
#include "host/image/colour_map.h"
#include "host/image/flip_colour.h"

using namespace candela;
using namespace candela::image;

namespace {

Image solid(const glm::vec3& colour, std::uint32_t width = 8, std::uint32_t height = 6) {
  return {width, height, std::vector<glm::vec3>(std::size_t{width} * height, colour), {}, {}, {}, {}};
}

double solidFlip(const glm::vec3& test, const glm::vec3& reference) {
  const FlipResult result = computeFlip(solid(test), solid(reference));
  CHECK(result.maximum == Approx(result.mean).margin(1e-9));
  return result.mean;
}

/// 12 x 9 pixels of 8-bit sRGB, channel c of (x, y) being (37 x + 91 y + 53 c + s (x y + c x^2)) mod 256.
Image pattern(unsigned s) {
  Pixels8 pixels{12, 9, {}};
  for (unsigned y = 0; y < 9; ++y) {
    for (unsigned x = 0; x < 12; ++x) {
      for (unsigned c = 0; c < 3; ++c) {
        pixels.rgb.push_back(static_cast<std::uint8_t>((37 * x + 91 * y + 53 * c + s * (x * y + c * x * x)) % 256));
      }
    }
  }
  return toImage(pixels);
}

}  // namespace

TEST_CASE("FLIP of an image with itself is zero") {
  const FlipResult result = computeFlip(pattern(5), pattern(5));
  CHECK(result.mean == 0);
  CHECK(result.maximum == 0);
  CHECK(result.error == std::vector<float>(12 * 9, 0.0f));
}

TEST_CASE("FLIP of two solid colours follows from their Hunt-adjusted Lab values") {
  // No edges, nothing for the filters to do: HyAB distance, its power, the bend. Green against blue is 1 by definition.
  // Computed with Python in binary64 from the paper's equations; black against white, for example: distance 100,
  // 100^0.7 = 25.1189 of 41.2761, beyond the bend at 16.5104: 0.95 + 0.05 (25.1189 - 16.5104) / 24.7657 = 0.96738.
  CHECK(solidFlip({0, 1, 0}, {0, 0, 1}) == Approx(1).margin(1e-9));
  CHECK(solidFlip({0, 0, 0}, {1, 1, 1}) == Approx(0.9673797614921327).margin(1e-7));
  CHECK(solidFlip({1, 0, 0}, {0, 1, 0}) == Approx(0.9866622751952875).margin(1e-7));
  CHECK(solidFlip({0.2f, 0.2f, 0.2f}, {0.21f, 0.21f, 0.21f}) == Approx(0.06198915533534095).margin(1e-6));
  CHECK(solidFlip({0.5f, 0.5f, 0.5f}, {0.6f, 0.4f, 0.1f}) == Approx(0.7280060479073904).margin(1e-6));
}

TEST_CASE("FLIP's colour spaces have the values of CIE Lab") {
  // White is (100, 0, 0), L* of 18 % grey 49.496, of green 87.736 and of blue 32.298; a*, b* of green -86.179, 83.183.
  CHECK(glm::length(flip::toHuntLab({1, 1, 1}) - glm::dvec3(100, 0, 0)) < 1e-9);
  CHECK(glm::length(flip::toHuntLab({0, 0, 0})) < 1e-9);
  CHECK(flip::toHuntLab(glm::dvec3(0.18)).x == Approx(49.496).epsilon(1e-5));
  const glm::dvec3 green = flip::toHuntLab({0, 1, 0});
  CHECK(green.x == Approx(87.73621066).epsilon(1e-9));
  CHECK(green.y == Approx(0.8773621066 * -86.17870509).epsilon(1e-9));
  CHECK(green.z == Approx(0.8773621066 * 83.18256604).epsilon(1e-9));
  CHECK(flip::hyab(green, flip::toHuntLab({0, 0, 1})) == Approx(203.3016546).epsilon(1e-9));
  const glm::dvec3 colour(0.3, 0.9, 0.05);
  CHECK(glm::length(flip::fromOpponent(flip::toOpponent(colour)) - colour) < 1e-12);
}

TEST_CASE("FLIP error maps equal those of direct two-dimensional filters") {
  // Expected: Python, binary64, from the paper's equations with unseparated filters and edges repeated.
  const std::size_t places[] = {0, 5, 40, 77, 107};
  const FlipResult far = computeFlip(pattern(5), pattern(0));
  const double farErrors[] = {0.20537631800780143, 0.4065596937187785, 0.2751058464356705, 0.5073635248807608,
                              0.5523915665148104};
  for (std::size_t i = 0; i < 5; ++i) CHECK(far.error[places[i]] == Approx(farErrors[i]).margin(1e-6));
  CHECK(far.mean == Approx(0.3858394406184446).margin(1e-6));
  CHECK(far.maximum == Approx(0.8269179636368038).margin(1e-6));

  const FlipResult near = computeFlip(pattern(5), pattern(0), 20);
  const double nearErrors[] = {0.08607991735431351, 0.9771449430567084, 0.9751956210966426, 0.5875781619805314,
                               0.839258233908139};
  for (std::size_t i = 0; i < 5; ++i) CHECK(near.error[places[i]] == Approx(nearErrors[i]).margin(1e-6));
  CHECK(near.mean == Approx(0.7563732552404802).margin(1e-6));
}

TEST_CASE("the FLIP error of a single pixel is largest at the pixel and zero far away") {
  Image dot = solid(glm::vec3(0), 9, 9);
  dot.at(4, 4) = glm::vec3(1);
  const FlipResult result = computeFlip(dot, solid(glm::vec3(0), 9, 9), 20);  // values as above
  CHECK(result.error[40] == Approx(0.989929689255259).margin(1e-6));
  CHECK(result.error[41] == Approx(0.4334077698535903).margin(1e-6));
  CHECK(result.error[0] == 0);
  CHECK(result.mean == Approx(0.03589405626631754).margin(1e-6));
}

TEST_CASE("FLIP clamps radiance to the range of the display") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  CHECK(solidFlip({5, infinity, 1}, {1, 1, 1}) == 0);
  CHECK(solidFlip({nan, -3, -infinity}, {0, 0, 0}) == 0);
}

TEST_CASE("FLIP refuses images of different sizes and impossible displays") {
  CHECK_THROWS_AS(computeFlip(solid({0, 0, 0}, 2, 3), solid({0, 0, 0}, 3, 2)), UsageError);
  for (const double pixelsPerDegree : {0.0, -67.0, 1e9, std::nan("")}) {
    CHECK_THROWS_AS(computeFlip(solid({0, 0, 0}), solid({0, 0, 0}), pixelsPerDegree), UsageError);
  }
  CHECK(computeFlip(Image(), Image()).mean == 0);
}

TEST_CASE("magma runs from black to pale yellow") {
  // Entries 0, 128 and 255 of matplotlib's table.
  CHECK(glm::length(magma(0) - glm::dvec3(0.001462, 0.000466, 0.013866)) < 0.02);
  CHECK(glm::length(magma(128 / 255.0) - glm::dvec3(0.716387, 0.214982, 0.475290)) < 0.02);
  CHECK(glm::length(magma(1) - glm::dvec3(0.987053, 0.991438, 0.749504)) < 0.03);
  CHECK(magma(7) == magma(1));
  CHECK(magma(std::nan("")) == magma(0));
}

TEST_CASE("the picture of a FLIP map shows magma's colours") {
  const FlipResult result{2, 1, {0, 1}, 0.5, 1};
  const Pixels8 pixels = toPixels8(errorPicture(result), {});
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(pixels.rgb[c] == std::lround(255 * magma(0)[static_cast<glm::length_t>(c)]));
    CHECK(pixels.rgb[3 + c] == std::lround(255 * magma(1)[static_cast<glm::length_t>(c)]));
  }
}
