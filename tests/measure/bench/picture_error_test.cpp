// The error of pictures whose truth and noise are known, and the share of confidence intervals that cover the truth.
#include "host/measure/bench/picture_error.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "host/base/errors.h"
#include "host/image/metrics.h"

namespace candela::bench {
namespace {

constexpr std::uint32_t kSide = 16;

image::Image uniform(float value, std::uint32_t width = 1, std::uint32_t height = 1) {
  image::Image picture;
  picture.width = width;
  picture.height = height;
  picture.rgb.assign(std::size_t{width} * height, glm::vec3(value));
  return picture;
}

// A picture of pixels from dark to bright, and pictures of it whose noise has the same relative variance everywhere.
class NoisyPictures {
 public:
  explicit NoisyPictures(double relativeVariance) : relativeVariance_(relativeVariance) {}

  /// The noise of pictures with `samples` times as many samples.
  double relMse(double samples) const { return relativeVariance_ / samples; }

  image::Image picture(double samples, double factor = 1) {
    image::Image picture = uniform(0, kSide, kSide);
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
      const double truth = 0.1 + 0.01 * static_cast<double>(i);
      const double deviation = std::sqrt(relMse(samples) * (truth * truth + 0.01));
      for (int c = 0; c < 3; ++c) picture.rgb[i][c] = static_cast<float>(factor * truth + deviation * normal_(engine_));
    }
    return picture;
  }
  ErrorReference reference(std::uint32_t count, double samples, double factor = 1) {
    std::vector<image::Image> pictures;
    for (std::uint32_t i = 0; i < count; ++i) pictures.push_back(picture(samples, factor));
    return errorReferenceOf(pictures);
  }
  /// Seconds of runs that vary by a twentieth.
  std::vector<double> seconds(double median, std::size_t count) {
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(median * (1 + 0.05 * normal_(engine_)));
    return all;
  }
  ErrorInTime measure(std::size_t count, double samples, double medianSeconds, const ErrorReference& reference) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < count; ++i) errors.push_back(relMseOf(picture(samples), reference));
    return errorInTime(errors, seconds(medianSeconds, count)).value();
  }

 private:
  double relativeVariance_;
  std::mt19937 engine_{1};
  std::normal_distribution<double> normal_;
};

bool covers(const ConfidentValue& interval, double truth) { return interval.low <= truth && truth <= interval.high; }

}  // namespace

TEST_CASE("the variance of a reference is that of the mean of its pictures, and is subtracted") {
  const std::vector<image::Image> pictures{uniform(1), uniform(3)};
  const ErrorReference reference = errorReferenceOf(pictures);
  CHECK(reference.rgb.at(0) == glm::dvec3(2));
  CHECK(reference.variance.at(0) == glm::dvec3(1));
  CHECK(relMseOf(uniform(5), reference) == Approx((9 - 1) / 4.01));
  CHECK(relMseOf(uniform(2), reference) == Approx(-1 / 4.01));
  const std::vector<image::Image> others{uniform(4), uniform(6), uniform(5)};  // variance of the mean: 1/3
  CHECK(relMseOf(errorReferenceOf(others), reference) == Approx((9 - 1 - 1.0 / 3) / 4.01));
}

TEST_CASE("with a reference without noise, the error is the relMSE of a comparison of images") {
  NoisyPictures noise(0.01);
  const image::Image truth = noise.picture(1e12), picture = noise.picture(1);
  const std::vector<image::Image> both{truth, truth};
  CHECK(relMseOf(picture, errorReferenceOf(both)) == Approx(compareImages(picture, truth).relativeMeanSquaredError));
}

TEST_CASE("the mean error is that of the picture, although the reference is noisy") {
  constexpr int kTrials = 300;
  NoisyPictures noise(0.01);
  double sum = 0, withoutSubtraction = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    ErrorReference reference = noise.reference(4, 2);
    const image::Image picture = noise.picture(1);
    sum += relMseOf(picture, reference) / kTrials;
    reference.variance.assign(reference.variance.size(), glm::dvec3(0));
    withoutSubtraction += relMseOf(picture, reference) / kTrials;
  }
  CHECK(sum == Approx(noise.relMse(1)).epsilon(0.015));
  CHECK(withoutSubtraction == Approx(noise.relMse(1) + noise.relMse(8)).epsilon(0.015));
}

TEST_CASE("an error that more samples do not reduce is counted, and converged pictures that are equal have none") {
  NoisyPictures noise(1e-4);
  const ErrorReference reference = noise.reference(8, 8);
  const double bias = relMseOf(noise.reference(8, 8, 1.1), reference);
  CHECK(bias == Approx(0.01).epsilon(0.1));  // (1.1 - 1)^2 m^2 / (m^2 + 0.01), and most pixels are bright
  CHECK(std::abs(relMseOf(noise.reference(8, 8), reference)) < 1e-6);
  CHECK(relMseOf(noise.picture(1, 1.1), reference) == Approx(bias + noise.relMse(1)).epsilon(0.1));
}

TEST_CASE("the error after a second is the root of relMSE x median seconds") {
  const std::vector<double> errors{0.01, 0.01}, seconds{4, 4};
  const ErrorInTime error = errorInTime(errors, seconds).value();
  CHECK(error.relMse().value == Approx(0.01));
  CHECK(error.inefficiency().value == Approx(0.04));
  CHECK(error.errorAfterSecond().value == Approx(0.2));
  CHECK(error.errorAfterSecond().low == error.errorAfterSecond().high);
  const std::vector<double> sixteenth{1.0 / 1600, 1.0 / 1600};
  CHECK(errorRatio(errorInTime(sixteenth, seconds).value(), error).value == Approx(0.25));
  const std::vector<double> outlier{9, 4, 3.9, 4.1, 4};
  CHECK(errorInTime(errors, outlier)->inefficiency().value == Approx(0.04));
}

TEST_CASE("an interval has Student's t of the pictures and of the runs") {
  const std::vector<double> errors{1, 3}, seconds{1, 1};
  const double t = 12.7062;  // 95 %, one degree of freedom; the standard error of the mean 2 is 1
  CHECK(errorInTime(errors, seconds)->relMse().high == Approx(2 * std::exp(t / 2)));
  CHECK(errorInTime(errors, seconds)->errorAfterSecond().low == Approx(std::sqrt(2 * std::exp(-t / 2))));
  const std::vector<double> noTime{1, 3};  // the median of normal values has 1.2533 times the error of their mean
  const double standardError = std::sqrt(0.25 + 0.25 * 1.2533 * 1.2533);
  const double freedom = std::pow(standardError, 4) / (std::pow(0.25, 2) + std::pow(0.25 * 1.2533 * 1.2533, 2));
  CHECK(errorInTime(errors, noTime)->inefficiency().high ==
        Approx(4 * std::exp(standardError * statistics::criticalT(0.05, freedom))));
}

TEST_CASE("intervals of 95 % cover the truth in 95 % of all measurements") {
  constexpr int kTrials = 1000;
  NoisyPictures noise(0.01);
  int covered = 0, ratios = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const ErrorReference reference = noise.reference(5, 8);
    const ErrorInTime one = noise.measure(5, 1, 2.0, reference), other = noise.measure(5, 4, 4.5, reference);
    covered += covers(one.errorAfterSecond(), std::sqrt(noise.relMse(1) * 2.0));
    ratios += covers(errorRatio(one, other), std::sqrt(4 * 2.0 / 4.5));
  }
  // The standard deviation of a share is 0.7 %.
  CHECK(covered > 0.93 * kTrials);
  CHECK(covered < 0.975 * kTrials);
  CHECK(ratios > 0.93 * kTrials);
  CHECK(ratios < 0.975 * kTrials);
}

TEST_CASE("pictures without noise have no error in equal time") {
  const std::vector<double> none{0, 0}, seconds{1, 1};
  CHECK_FALSE(errorInTime(none, seconds));
}

TEST_CASE("pictures of different sizes have no error, and a reference needs two pictures") {
  const std::vector<image::Image> one{uniform(1)}, unequal{uniform(1), uniform(1, 2)}, pair{uniform(1), uniform(1)};
  CHECK_THROWS_AS(errorReferenceOf(one), UsageError);
  CHECK_THROWS_AS(errorReferenceOf(unequal), UsageError);
  CHECK_THROWS_AS(relMseOf(uniform(1, 1, 2), errorReferenceOf(pair)), UsageError);
}

TEST_CASE("pixels that are not finite are ignored") {
  image::Image picture = uniform(3, 2);
  picture.rgb[1].y = std::numeric_limits<float>::infinity();
  const std::vector<image::Image> pair{uniform(2, 2), uniform(2, 2)};
  CHECK(relMseOf(picture, errorReferenceOf(pair)) == Approx(1 / 4.01));
}

}  // namespace candela::bench
