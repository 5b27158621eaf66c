// The test of two finished films: values computed by hand, false alarms and power on films of known light, and
// refusals.
#include "host/judge/verify/film_test.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <random>

namespace candela::verify {
namespace {

using Catch::Contains;

struct FilmOptions {
  std::uint32_t side = 16;
  std::uint32_t samples = 16;
  double factor = 1;
  double fireflyFraction = 0;  ///< of the samples; a firefly adds 500, and the mean stays
};

// Exponentially distributed samples of mean 1 (skewed, as radiance is), with fireflies on request.
image::Image noisyFilm(std::uint32_t seed, const FilmOptions& options) {
  constexpr double kFirefly = 500;
  std::mt19937 random(seed);
  std::exponential_distribution<double> noise;
  std::bernoulli_distribution isFirefly(options.fireflyFraction);
  image::Film film(options.side, options.side);
  for (std::uint32_t y = 0; y < options.side; ++y) {
    for (std::uint32_t x = 0; x < options.side; ++x) {
      for (std::uint32_t sample = 0; sample < options.samples; ++sample) {
        const double value = noise(random) + (isFirefly(random) ? kFirefly : 0);
        film.addSample(x, y, glm::dvec3(options.factor * value), sample);
      }
    }
  }
  image::Image image = toImage(film);
  image.metadata[kSeedMetadata] = std::to_string(seed);
  return image;
}

int falseAlarmsOf(int runs, const FilmOptions& a, const FilmOptions& b, double alpha) {
  int alarms = 0;
  for (int i = 0; i < runs; ++i) {
    const auto seed = static_cast<std::uint32_t>(2 * i);
    alarms += testFilms(noisyFilm(seed, a), noisyFilm(seed + 1, b), {.alpha = alpha}).differs() ? 1 : 0;
  }
  return alarms;
}

// Two grey pixels.
image::Image twoPixels(float left, float right, float leftVariance, float rightVariance, std::uint32_t samples,
                       const std::string& seed) {
  return {2,
          1,
          {glm::vec3(left), glm::vec3(right)},
          {leftVariance, rightVariance},
          {samples, samples},
          {},
          {{kSeedMetadata, seed}}};
}

TEST_CASE("the error of a region's mean is the root of the sum of its pixels' variances") {
  // Squared errors of the pixels 4/4 and 8/4, so of the mean (1 + 2) / 2^2; freedom (1 + 2)^2 / (1^2/3 + 2^2/3) = 5.4.
  const image::Image a = twoPixels(1, 3, 4, 8, 4, "1");
  // 4/4 and 4/4: (1 + 1) / 2^2; freedom (1 + 1)^2 / (1/3 + 1/3) = 6.
  const image::Image b = twoPixels(1, 2, 4, 4, 4, "2");
  const FilmTestResult result = testFilms(a, b, {.alpha = 0.01});
  REQUIRE(result.regions.size() == 1);
  CHECK(result.level == Approx(0.01));
  CHECK(result.image().deviceMean == Approx(2));
  CHECK(result.image().referenceMean == Approx(1.5));
  CHECK(result.image().test.standardError == Approx(std::sqrt(1.25)));
  CHECK(result.image().test.degreesOfFreedom == Approx(1.25 * 1.25 / (0.75 * 0.75 / 5.4 + 0.5 * 0.5 / 6)));
  CHECK(result.image().test.t == Approx((0.5 - 1.5e-4) / std::sqrt(1.25)));
  CHECK_FALSE(result.differs());
}

TEST_CASE("a pixel with unequal counts has the larger of the two variances") {
  const FilmTestResult result = testFilms(twoPixels(1, 1, 4, 0, 4, "1"), twoPixels(1, 1, 0, 16, 16, "2"),
                                          {.alpha = 0.01});
  // (4 + 16) / 4 / 2^2 + (4 + 16) / 16 / 2^2
  CHECK(result.image().test.standardError == Approx(std::sqrt(1.25 + 0.3125)));
}

TEST_CASE("images without noise are equal up to rounding, or differ for certain") {
  CHECK_FALSE(testFilms(twoPixels(1, 1, 0, 0, 4, "1"), twoPixels(1.0001f, 1, 0, 0, 4, "2"), {.alpha = 0.01}).differs());
  const FilmTestResult result = testFilms(twoPixels(1, 1, 0, 0, 4, "1"), twoPixels(1.01f, 1, 0, 0, 4, "2"),
                                          {.alpha = 0.01});
  CHECK(result.differs());
  CHECK_THAT(result.verdict(), Contains("darker in A (p < 1e-300 over all tests)"));
}

TEST_CASE("films of equal light raise no alarm at the default level, and the expected number at another") {
  CHECK(falseAlarmsOf(200, {}, {}, 1e-4) == 0);
  const int alarms = falseAlarmsOf(200, {}, {}, 0.05);
  CHECK(alarms >= 2);
  CHECK(alarms <= 21);
}

TEST_CASE("fireflies that one side has not seen yet raise no alarm") {
  const FilmOptions few{.samples = 8, .fireflyFraction = 5e-4};
  const FilmOptions many{.samples = 128, .fireflyFraction = 5e-4};
  CHECK(falseAlarmsOf(200, few, few, 0.05) <= 21);
  CHECK(falseAlarmsOf(100, few, many, 0.05) <= 10);
}

TEST_CASE("a bias of the size that the verdict calls detectable is detected in 99 of 100 comparisons, on either side") {
  // sigma = mean, 16 x 16 x 16 samples: standard error 2^0.5 / 64 of the mean; level 1e-4 / 5 at 5 tests.
  const double detectable = testFilms(noisyFilm(1, {}), noisyFilm(2, {}), {.alpha = 1e-4}).image().detectableBias;
  CHECK(detectable == Approx((4.2649 + 2.3263) * std::sqrt(2.0) / 64).epsilon(0.05));
  CHECK(falseAlarmsOf(100, {.factor = 1 + 1.1 * detectable}, {}, 1e-4) >= 99);
  CHECK(falseAlarmsOf(100, {.factor = 1 / (1 + 1.1 * detectable)}, {}, 1e-4) >= 98);
}

TEST_CASE("a difference in one tile is reported at this tile") {
  image::Image a = noisyFilm(1, {.side = 32, .samples = 64});
  const image::Image b = noisyFilm(2, {.side = 32, .samples = 64});
  CHECK_FALSE(testFilms(a, b, {.alpha = 1e-4}).differs());
  for (std::uint32_t y = 8; y < 16; ++y) {
    for (std::uint32_t x = 24; x < 32; ++x) a.at(x, y) *= 1.25f;
  }
  const FilmTestResult result = testFilms(a, b, {.alpha = 1e-4});
  REQUIRE(result.differs());
  CHECK_FALSE(result.image().differs);
  CHECK_THAT(result.verdict(), Contains("tile 8x8 at 24,8") && Contains("brighter in A"));
  CHECK(toJson(result)["regions"].size() == 1 + 16 + 4);
}

TEST_CASE("films that cannot be tested are refused with the reason") {
  const image::Image good = twoPixels(1, 1, 1, 1, 4, "1");
  CHECK_FALSE(whyNotTestable(good, twoPixels(1, 1, 1, 1, 4, "2")));
  CHECK_THAT(*whyNotTestable(good, twoPixels(2, 2, 1, 1, 4, "1")), Contains("the same seed"));
  CHECK_THAT(*whyNotTestable(good, twoPixels(1, 1, 1, 1, 1, "2")),
             Contains("B has pixels with fewer than two samples"));
  image::Image biased = twoPixels(1, 1, 1, 1, 4, "2");
  biased.metadata[kBiasMetadata] = "too dark";
  CHECK_THAT(*whyNotTestable(good, biased), Contains("B is biased on purpose"));
  CHECK_THAT(*whyNotTestable(twoPixels(1, 1, -1, 1, 4, "2"), good), Contains("A has values that are not finite"));
  CHECK_THAT(*whyNotTestable(twoPixels(1, NAN, 1, 1, 4, "2"), good), Contains("A has values that are not finite"));
  image::Image bare = good;
  bare.metadata.clear();
  CHECK_THAT(*whyNotTestable(bare, good), Contains("A does not state its seed"));
  bare.luminanceVariance.clear();
  CHECK_THAT(*whyNotTestable(good, bare), Contains("B has no variance"));
}

}  // namespace
}  // namespace candela::verify
