// Image metrics, compared with values computed by hand.
#include "host/image/metrics.h"

#include <catch2/catch.hpp>
#include <limits>

#include "host/base/errors.h"
#include "tests/image/test_images.h"

using namespace candela;
using namespace candela::image;

namespace {

constexpr float kInfinitePixel = std::numeric_limits<float>::infinity();
constexpr float kNanPixel = std::numeric_limits<float>::quiet_NaN();

Image row(const std::vector<glm::vec3>& pixels) {
  return {static_cast<std::uint32_t>(pixels.size()), 1, pixels, {}, {}, {}, {}};
}

}  // namespace

TEST_CASE("metrics of two pixels are those computed by hand") {
  const ImageComparison c = compareImages(row({{0.5f, 0.5f, 0.5f}, {2, 0, 1}}), row({{0.5f, 0.25f, 0.5f}, {1, 0, 0}}));
  CHECK(c.width == 2);
  CHECK(c.height == 1);
  CHECK(c.notFiniteCount == 0);
  CHECK(c.mean == glm::dvec3(1.25, 0.25, 0.75));
  CHECK(c.referenceMean == glm::dvec3(0.75, 0.125, 0.25));
  CHECK(c.meanLuminance == Approx(0.2126 * 1.25 + 0.7152 * 0.25 + 0.0722 * 0.75));
  CHECK(c.referenceMeanLuminance == Approx(0.2126 * 0.75 + 0.7152 * 0.125 + 0.0722 * 0.25));
  CHECK(c.relativeMeanDifference == Approx(0.49870 / 0.26690 - 1).epsilon(1e-9));
  CHECK(c.meanSquaredError == Approx((0.0625 + 1 + 1) / 6));
  CHECK(c.relativeMeanSquaredError == Approx((0.0625 / 0.0725 + 1 / 1.01 + 1 / 0.01) / 6));
  // Clamped to [0, 1] the second pixel's red is equal: MSE 1.0625 / 6, 10 log10(6 / 1.0625) = 7.5182.
  CHECK(c.peakSignalToNoise == Approx(7.5182).epsilon(1e-5));
  CHECK(c.maximumDifference == 1);
  CHECK(c.maximumX == 1);
  CHECK(c.maximumY == 0);
  CHECK(c.differingCount == 2);
  CHECK(c.differingFraction == 1);
}

TEST_CASE("equal images have no difference and infinite PSNR") {
  const ImageComparison c = compareImages(testImage(9, 5), testImage(9, 5));
  CHECK(c.meanSquaredError == 0);
  CHECK(c.relativeMeanSquaredError == 0);
  CHECK(c.relativeMeanDifference == 0);
  CHECK(c.maximumDifference == 0);
  CHECK(c.differingCount == 0);
  CHECK(c.peakSignalToNoise == std::numeric_limits<double>::infinity());
}

TEST_CASE("pixels count as different beyond the relative and the absolute tolerance") {
  const DifferenceTolerance tolerance{0.125, 0.5};
  const Image reference = row({{8, 0, 0}, {8, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, -8}});
  const Image a = row({{9, 0, 0}, {9.01f, 0, 0}, {1.5f, 0, 0}, {1, 0, 0.51f}, {0, 0, -9.5f}});
  const ImageComparison c = compareImages(a, reference, tolerance);
  CHECK(c.differingCount == 3);
  CHECK(c.differingFraction == Approx(0.6));
  CHECK(c.maximumX == 4);
  // The default: 1e-4 of the reference, or 2^-26.
  CHECK(compareImages(row({{1.00009f, 0, 0x1p-26f}}), row({{1, 0, 0}})).differingCount == 0);
  CHECK(compareImages(row({{1.00011f, 0, 0}}), row({{1, 0, 0}})).differingCount == 1);
  CHECK(compareImages(row({{0, 0x1p-25f, 0}}), row({{0, 0, 0}})).differingCount == 1);
}

TEST_CASE("pixels that are not finite are counted and ignored") {
  const Image reference = row({{1, 1, 1}, {1, 1, 1}, {kNanPixel, 1, 1}, {1, 1, 1}});
  const Image a = row({{2, 2, 2}, {kInfinitePixel, 1, 1}, {1, 1, 1}, {1, 1, -kInfinitePixel}});
  const ImageComparison c = compareImages(a, reference);
  CHECK(c.notFiniteCount == 3);
  CHECK(c.mean == glm::dvec3(2));
  CHECK(c.relativeMeanDifference == Approx(1));
  CHECK(c.meanSquaredError == 1);
  CHECK(c.differingFraction == 1);

  const ImageComparison none = compareImages(row({{kNanPixel, 0, 0}}), row({{0, 0, 0}}));
  CHECK(none.notFiniteCount == 1);
  CHECK(none.meanSquaredError == 0);
  CHECK(none.differingFraction == 0);
}

TEST_CASE("images of different sizes are refused") {
  CHECK_THROWS_AS(compareImages(testImage(2, 3), testImage(3, 2)), UsageError);
  CHECK_THROWS_AS(differencePicture(testImage(2, 3), testImage(3, 2)), UsageError);
}

TEST_CASE("a pixel that is lit where the reference is black has an infinite relative difference") {
  CHECK(compareImages(row({{1, 1, 1}}), row({{0, 0, 0}})).relativeMeanDifference ==
        std::numeric_limits<double>::infinity());
  CHECK(compareImages(row({{0, 0, 0}}), row({{0, 0, 0}})).relativeMeanDifference == 0);
}

TEST_CASE("the JSON of a comparison contains its numbers, and null for infinity") {
  const ImageComparison c = compareImages(row({{1, 1, 2}}), row({{1, 1, 2}}));
  const nlohmann::json json = nlohmann::json::parse(toJson(c).dump());
  CHECK(json.at("size") == "1x1");
  CHECK(json.at("mean") == nlohmann::json({1.0, 1.0, 2.0}));
  CHECK(json.at("meanSquaredError") == 0.0);
  CHECK(json.at("peakSignalToNoise").is_null());
  CHECK(json.at("relativeTolerance") == 1e-4);
}

TEST_CASE("the text of a comparison names its figures") {
  const std::string text = toText(compareImages(row({{2, 1, 1}, {kNanPixel, 1, 1}}), row({{1, 1, 1}, {1, 1, 1}})));
  CHECK_THAT(text, Catch::Contains("2 x 1") && Catch::Contains("relMSE") && Catch::Contains("1 pixels, ignored") &&
                       Catch::Contains("+21.26 %") && Catch::Contains("maximum difference    1 at 0 0"));
}

TEST_CASE("a difference picture is orange where brighter, blue where darker, black where equal") {
  const Image reference = row({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  const Image a = row({{1, 1, 1}, {2, 2, 2}, {0, 0, 0}, {kNanPixel, 1, 1}});
  const Pixels8 picture = toPixels8(differencePicture(a, reference), {});
  const std::vector<int> signals(picture.rgb.begin(), picture.rgb.end());
  // The bound 255 * (1, 0.55, 0.1) and 255 * (0.15, 0.5, 1), rounded.
  CHECK(signals == std::vector<int>{0, 0, 0, 255, 140, 26, 38, 128, 255, 255, 0, 255});
  // 5 % brighter at a range of 10 %, with a scale of 1 % of the mean: 0.05 / 1.01 / 0.1 = 0.4950 of full strength.
  const Pixels8 halved = toPixels8(differencePicture(row({{1.05f, 1.05f, 1.05f}}), row({{1, 1, 1}})), {});
  CHECK(halved.rgb[0] == 126);
  CHECK_THROWS_AS(differencePicture(a, reference, 0), UsageError);
}
