// Variances from moments and from pictures of variances, as Mitsuba writes them.
#include "host/image/moments.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "host/base/errors.h"

namespace candela::image {
namespace {

Image onePixel() { return {1, 1, {glm::vec3(2)}, {}, {}, {}, {}}; }

TEST_CASE("the variance of the luminance is the second moment of Y minus the square of its mean") {
  Image image = onePixel();
  CHECK_FALSE(takeMoments(image));
  image.channels = {{"nested.X", {9}},     {"nested.Y", {2}},    {"nested.Z", {9}},
                    {"m2_nested.X", {99}}, {"m2_nested.Y", {7}}, {"m2_nested.Z", {99}}};
  CHECK(takeMoments(image));
  CHECK(image.luminanceVariance == std::vector<float>{3});
  image.channels[4].values = {3.99f};  // rounded
  CHECK(takeMoments(image));
  CHECK(image.luminanceVariance == std::vector<float>{0});
  image.channels[4].values = {NAN};
  CHECK(takeMoments(image));
  CHECK(std::isnan(image.luminanceVariance[0]));
  image.channels.push_back({"m2_other.Y", {1}});
  CHECK_THROWS_WITH(takeMoments(image), Catch::Contains("m2_nested.Y and m2_other.Y"));
}

TEST_CASE("a picture of variances in R, G and B, made from X, Y and Z, gives back Y") {
  // X, Y and Z of 1, 4 and 2 by the matrix of Rec. 709.
  const glm::vec3 rgb(3.240479 * 1 - 1.537150 * 4 - 0.498535 * 2, -0.969256 * 1 + 1.875991 * 4 + 0.041556 * 2,
                      0.055648 * 1 - 0.204043 * 4 + 1.057311 * 2);
  Image image = onePixel();
  Image variances = onePixel();
  variances.rgb[0] = rgb;
  takeVariances(image, variances);
  CHECK(rgb.r < 0);
  CHECK(image.luminanceVariance[0] == Approx(4).epsilon(1e-3));
  variances.rgb[0] = glm::vec3(1e-7f, -4e-8f, 1e-7f);
  CHECK_NOTHROW(takeVariances(image, variances));
  image.rgb[0] = glm::vec3(2);
  variances.rgb[0] = glm::vec3(-0.003f);  // by the rounding of sums of squares, which are 4
  takeVariances(image, variances);
  CHECK(image.luminanceVariance[0] == 0);
  variances.rgb[0] = glm::vec3(-0.01f);
  CHECK_THROWS_AS(takeVariances(image, variances), FileError);
  variances.rgb[0] = glm::vec3(0, -1, 0);
  CHECK_THROWS_AS(takeVariances(image, variances), FileError);
  variances.origin.x = 1;
  CHECK_THROWS_WITH(takeVariances(image, variances), Catch::Contains("not where"));
}

}  // namespace
}  // namespace candela::image
