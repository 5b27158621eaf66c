// The test of renders against a picture with variances: values computed by hand, and the fireflies of one side.
#include "host/judge/verify/picture_test.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/judge/verify/film_test.h"
#include "tests/judge/verify/set_cases.h"

namespace candela::verify {
namespace {

using Catch::Contains;

// Two grey pixels with the same variance of one sample.
image::Image greyPair(float left, float right, float variance = 0, std::uint32_t samples = 0) {
  image::Image image{2, 1, {glm::vec3(left), glm::vec3(right)}, {}, {}, {}, {}};
  if (samples > 0) {
    image.luminanceVariance.assign(2, variance);
    image.sampleCounts.assign(2, samples);
  }
  return image;
}

RenderSet pairsOf(const std::vector<float>& values) {
  RenderSet set;
  for (const float value : values) set.add(greyPair(value, value));
  return set;
}

TEST_CASE("a picture's error counts, and so does the larger error of the renders") {
  // Renders 1, 2, 3: mean 2, squared error 1 / 3 among renders; from variances 4 / 30 / 2 for 30 samples in two pixels.
  // The picture: 4 / 100 / 2 in two pixels.
  const SamplesOfA samples{{30, 30}};
  const SetTestResult noisy = testAgainstPicture(pairsOf({1, 2, 3}), samples, greyPair(5, 5, 4, 100), {.alpha = 0.05});
  REQUIRE(noisy.regions.size() == 1);
  CHECK(noisy.image().test.standardError == Approx(std::sqrt(1.0 / 3 + 0.02)));
  CHECK(noisy.image().margin == Approx(5e-4).epsilon(1e-4));
  CHECK(noisy.options.design == SetDesign::picture);
  const SetTestResult even = testAgainstPicture(pairsOf({2, 2.0001f, 1.9999f}), samples, greyPair(5, 5, 4, 100), {});
  CHECK(even.image().test.standardError == Approx(std::sqrt(4.0 / 30 / 2 + 0.02)));
  CHECK(even.differs());
  CHECK_THAT(toText(even), Contains("NO: 3 renders of A and one picture with variances, 1 tests together"));
  CHECK(toJson(even)["design"] == "picture");
  CHECK_FALSE(toJson(even).contains("minPValue"));
}

TEST_CASE("a single render has the larger of its own variances and the picture's") {
  const SamplesOfA samples{{10, 10}, {9, 1}};
  const SetTestResult result = testAgainstPicture(pairsOf({2}), samples, greyPair(2, 2, 4, 100), {.alpha = 0.05});
  CHECK(result.image().test.standardError == Approx(std::sqrt((9 + 4) / 10.0 / 4 + 0.02)));
  CHECK(result.pValue == 1);
}

TEST_CASE("fireflies that the picture has found and the renders have not raise no alarm, and a bias does") {
  const SetCase one = pictureCases().back();
  int alarms = 0, found = 0;
  for (std::uint32_t run = 0; run < 40; ++run) {
    const SetPictures pictures = picturesOf(one, run);
    alarms += testPictures(one, pictures, 0.05).differs() ? 1 : 0;
    found += testPictures(one, pictures, 0.05, 2).differs() ? 1 : 0;
  }
  CHECK(alarms <= 6);
  CHECK(found >= 36);
}

// The squared error of a region's mean from independent pixels is right for splatted samples, because the filter's
// weights add up to 1.
TEST_CASE("the variances of splatted samples predict the spread of a tile's mean among renders") {
  const MadeOptions options{.samples = 16, .isSplatted = true};
  const Region tile{8, 8, 16, 16, 16};
  std::vector<double> means;
  double predicted = 0;
  constexpr std::uint32_t kRenders = 200;
  for (std::uint32_t seed = 0; seed < kRenders; ++seed) {
    const image::Image image = MadeRender(seed, options).imageWithVariances();
    means.push_back(regionMean(image, tile));
    predicted += estimateRegion(image, image.luminanceVariance, tile).squaredError / kRenders;
  }
  const double measured = statistics::summarise(means).variance;
  CHECK(predicted / measured > 0.8);
  CHECK(predicted / measured < 1.4);
}

}  // namespace
}  // namespace candela::verify
