// The test of two sets of renders: values computed by hand, refusals, verdicts, false alarms and power.
#include "host/judge/verify/render_set_test.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "tests/judge/verify/made_renders.h"

namespace candela::verify {
namespace {

using Catch::Contains;

image::Image greyPicture(float value, std::uint32_t width = 2) {
  image::Image image;
  image.width = width;
  image.height = 1;
  image.rgb.assign(width, glm::vec3(value));
  return image;
}

RenderSet greySet(const std::vector<float>& values) {
  RenderSet set;
  for (const float value : values) set.add(greyPicture(value));
  return set;
}

RenderSet madeSet(std::uint32_t firstSeed, std::size_t count, const MadeOptions& options) {
  RenderSet set;
  for (std::uint32_t i = 0; i < count; ++i) set.add(MadeRender(firstSeed + i, options).image());
  return set;
}

TEST_CASE("a set keeps the means of its regions and the mean picture") {
  RenderSet set;
  image::Image image = greyPicture(1);
  image.rgb[1] = {3, 1, 1};
  set.add(image);
  set.add(greyPicture(2));
  REQUIRE(set.regions().size() == 4);  // luminance, red, green and blue of the image, which is a single tile
  CHECK(set.count() == 2);
  CHECK(set.means()[0][0] == Approx(1 + 0.2126 * 2 / 2));
  CHECK(set.means()[0][1] == 2);
  CHECK(set.means()[0][2] == 1);
  CHECK(set.means()[1][1] == 2);
  CHECK(set.mean().rgb[1] == glm::vec3(2.5f, 1.5f, 1.5f));
}

TEST_CASE("renders of a set that cannot be compared are refused with the reason") {
  RenderSet set = greySet({1});
  CHECK_THROWS_WITH(set.add(greyPicture(1, 3)), Contains("the size 3x1") && Contains("the size 2x1"));
  image::Image crop = greyPicture(1);
  crop.frame = image::PixelBox{0, 0, 4, 4};
  CHECK_THROWS_WITH(set.add(crop), Contains("the window 0,0,2,1 of the frame 0,0,4,4"));
  image::Image endless = greyPicture(1);
  endless.rgb[1].g = INFINITY;
  endless.origin = {0, 0};
  CHECK_THROWS_WITH(set.add(endless), Contains("the pixel 1,0 is not finite (1 such pixels)"));
  image::Image shown = greyPicture(1);
  shown.isDisplayReferred = true;
  CHECK_THROWS_AS(set.add(shown), FileError);
  CHECK(set.count() == 1);
}

TEST_CASE("a render with the means of another one is its twin") {
  RenderSet set = greySet({1, 2});
  CHECK_FALSE(set.twinOfLast());
  set.add(greyPicture(1));
  CHECK(set.twinOfLast() == 0);
}

TEST_CASE("independent sets are compared by Welch's statistic and by the divisions of their renders") {
  // Means 2 and 6, variances 1 and 1: standard error sqrt(2 / 3); margin 1e-4 times the mean of all, 4.
  const SetTestResult result = testRenderSets(greySet({1, 2, 3}), greySet({5, 6, 7}), {.alpha = 0.1});
  CHECK(result.image().deviceMean == Approx(2));
  CHECK(result.image().referenceMean == Approx(6));
  CHECK(result.image().test.standardError == Approx(std::sqrt(2.0 / 3)));
  CHECK(result.image().margin == Approx(4e-4).epsilon(1e-4));
  CHECK(result.image().test.t == Approx((4 - 4e-4) / std::sqrt(2.0 / 3)));
  CHECK(result.pValue == Approx(2.0 / 20));
  CHECK(result.image().test.pValue == result.pValue);
  CHECK(result.differs());
  const RelativeDifference relative = relativeDifferenceOf(result.image());
  CHECK(relative.value == Approx(-4.0 / 6));
  CHECK(relative.low == Approx((-4 - 2.776445 * std::sqrt(2.0 / 3)) / 6));  // t of 4 degrees of freedom
  CHECK(relative.high == Approx((-4 + 2.776445 * std::sqrt(2.0 / 3)) / 6));
  CHECK_THAT(result.verdict(), Contains("do NOT show the same light: the image mean (luminance) of A differs") &&
                                   Contains("-66.7 % (95 % confidence:"));
}

TEST_CASE("pairs are compared by their differences") {
  const SetTestResult result = testRenderSets(greySet({1, 5, 9, 3}), greySet({2, 7, 10, 5}),
                                              {.design = SetDesign::paired, .alpha = 0.1});
  CHECK(result.image().test.difference == Approx(-1.5));
  CHECK(result.image().test.standardError == Approx(std::sqrt(1.0 / 3 / 4)));
  CHECK(result.pValue == Approx(2.0 / 16));
  CHECK(result.doubt() == Doubt::renders);
  CHECK_THAT(result.verdict(), Contains("the p-value of 4 pairs is at least 0.12, and the level is 0.1. At least 5 "));
}

TEST_CASE("pairs that are equal are the same light, however few they are") {
  const SetTestResult result = testRenderSets(greySet({1, 2}), greySet({1, 2}), {.design = SetDesign::paired});
  CHECK(result.conclusion() == Conclusion::same);
  CHECK_THAT(result.verdict(), Contains("the renders of each pair are equal"));
  CHECK(testRenderSets(greySet({1, 2}), greySet({1, 2}), {}).conclusion() == Conclusion::undecided);
}

TEST_CASE("too few renders for the level are not decided, with the number that is needed") {
  const SetTestResult four = testRenderSets(greySet({1, 2, 3, 4}), greySet({11, 12, 13, 14}), {.alpha = 0.01});
  CHECK(four.conclusion() == Conclusion::undecided);
  CHECK(four.doubt() == Doubt::renders);
  CHECK(four.minPValue == Approx(2.0 / 70));
  CHECK_THAT(four.verdict(), Contains("4 renders of A and 4 of B is at least 0.029, and the level is 0.01. At least 5 "
                                      "renders on each side"));
  const SetTestResult single = testRenderSets(greySet({1}), greySet({2}), {});
  CHECK(single.doubt() == Doubt::renders);
  CHECK(toJson(single)["undecided"]["reason"] == "renders");
  CHECK_THAT(toText(single), Contains("with an unknown error"));
  CHECK(testRenderSets(greySet({1, 2, 3, 4}), greySet({11, 12, 13, 14}), {.alpha = 0.05}).differs());
}

TEST_CASE("the smallest numbers of renders are those of docs/comparing-renderers.md") {
  for (const auto& [alpha, renders, pairs] :
       {std::tuple{0.05, 4u, 6u}, {0.01, 5u, 8u}, {0.001, 7u, 11u}, {1e-4, 9u, 15u}, {1e-6, 12u, 21u}}) {
    CHECK(minRenders(SetDesign::independent, alpha) == renders);
    CHECK(minRenders(SetDesign::paired, alpha) == pairs);
  }
}

TEST_CASE("what noise or the precision of files may hide leaves the verdict open") {
  const RenderSet a = madeSet(1, 6, {}), b = madeSet(100, 6, {});
  const SetTestResult open = testRenderSets(a, b, {.alpha = 0.05});
  CHECK(open.doubt() == Doubt::noise);
  CHECK(testRenderSets(a, b, {.alpha = 0.05, .maxOverlooked = 0.5}).conclusion() == Conclusion::same);
  RenderSet coarse;
  for (const float value : {1.0f, 1.001f, 0.999f, 1.002f}) {
    image::Image image = greyPicture(value);
    image.significandBits = 8;
    coarse.add(image);
  }
  CHECK(coarse.significandBits() == 8);
  const SetTestResult rounded = testRenderSets(coarse, greySet({1.003f, 1.002f, 1.001f, 1.0025f}),
                                               {.alpha = 0.05, .maxOverlooked = 1e-3});
  CHECK(rounded.doubt() == Doubt::rounding);
  CHECK(rounded.image().margin == Approx(1.0 / 256).epsilon(0.01));
  CHECK_THAT(rounded.verdict(), Contains("the files round their values to 8 bits, which may hide 0.39 %"));
  CHECK(testRenderSets(greySet({0, 1e-3f, 2e-3f, 3e-3f}), greySet({0, 0, 0, 0}), {.alpha = 0.05}).doubt() ==
        Doubt::darkness);
}

TEST_CASE("a difference of two sets in one tile is reported at this tile") {
  RenderSet a, b;
  for (std::uint32_t i = 0; i < 12; ++i) {
    image::Image image = MadeRender(i, {.samples = 16}).image();
    for (std::uint32_t y = 8; y < 16; ++y) {
      for (std::uint32_t x = 24; x < 32; ++x) image.at(x, y) *= 1.3f;
    }
    a.add(image);
    b.add(MadeRender(100 + i, {.samples = 16}).image());
  }
  const SetTestResult result = testRenderSets(a, b, {});
  REQUIRE(result.differs());
  CHECK(result.mostSignificant().region.x == 24);
  CHECK(result.mostSignificant().region.y == 8);
  CHECK_THAT(result.verdict(), Contains("tile 8x8 at 24,8"));
  CHECK(toJson(result)["regions"].size() == 4 + 16 + 4);
}

TEST_CASE(
    "a bias of the size that verdicts on two sets call detectable on average is detected in 99 of 100 comparisons") {
  constexpr std::uint32_t kRuns = 60;
  const MadeOptions options{.side = 16};
  double detectable = 0;
  for (std::uint32_t run = 0; run < kRuns; ++run) {
    const RenderSet a = madeSet(40 * run, 8, options), b = madeSet(40 * run + 20, 8, options);
    detectable += testRenderSets(a, b, {.alpha = 0.01}).image().detectableBias / kRuns;
  }
  CHECK(detectable == Approx(0.153).epsilon(0.1));
  const auto foundAt = [&](double bias) {
    MadeOptions biased = options;
    biased.factor = 1 + bias;
    std::uint32_t found = 0;
    for (std::uint32_t run = 0; run < kRuns; ++run) {
      const RenderSet a = madeSet(10000 + 40 * run, 8, biased), b = madeSet(10020 + 40 * run, 8, options);
      found += testRenderSets(a, b, {.alpha = 0.01}).differs() ? 1 : 0;
    }
    return found;
  };
  CHECK(foundAt(detectable) >= kRuns - 3);
  CHECK(foundAt(detectable / 2) < kRuns - 10);
}

}  // namespace
}  // namespace candela::verify
