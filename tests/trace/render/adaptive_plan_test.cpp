// The decisions of adaptive sampling, on films that are filled with random numbers instead of light.
#include "host/trace/render/adaptive_plan.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "host/base/errors.h"
#include "host/trace/render/adaptive_summary.h"

using namespace candela;
using namespace candela::render;

namespace {

/// Radiance of a sample of a pixel, by which films are filled.
using Light = std::function<double(std::uint32_t x, std::uint32_t y, std::uint32_t sample)>;

// Hash of four words: a number in [0, 1).
double uniformAt(std::uint32_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample) {
  std::seed_seq words{seed, x, y, sample};
  std::uint32_t word = 0;
  words.generate(&word, &word + 1);
  return word * 0x1p-32;
}

// Adds to selected pixels the samples that they lack before `end`.
void fill(image::Film& film, const PixelMask& mask, std::uint32_t end, const Light& light) {
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) {
      if (!isSelected(mask, std::size_t{y} * film.width() + x)) continue;
      for (std::uint32_t i = film.at(x, y).sampleCount; i < end; ++i) {
        film.addSample(x, y, glm::dvec3(light(x, y, i)), i);
      }
    }
  }
}

image::Film sampled(const AdaptivePlan& plan, const Extent& size, const Light& light) {
  image::Film film(size.width, size.height);
  while (const auto step = plan.next(film)) fill(film, step->pixels, step->sampleEnd, light);
  return film;
}

std::uint32_t countAt(const image::Film& film, std::uint32_t x, std::uint32_t y) { return film.at(x, y).sampleCount; }

}  // namespace

TEST_CASE("adaptive: the pilot grows with the square of the reciprocal threshold") {
  CHECK(pilotSamples(10) == 16);
  CHECK(pilotSamples(0.1) == 16);
  CHECK(pilotSamples(0.08) == 16);
  CHECK(pilotSamples(0.079) == 32);
  CHECK(pilotSamples(0.05) == 64);
  CHECK(pilotSamples(0.025) == 256);
  CHECK(pilotSamples(1e-6) == 1u << 20);
}

TEST_CASE("adaptive: noisy regions need samples for the threshold, others in proportion to their deviation") {
  CHECK(neededSamples(9, 3, 0.1) == Approx(900));
  CHECK(neededSamples(4, 2, 0.1) == Approx(500));
  CHECK(neededSamples(0.25, 0.5, 0.1) == Approx(125));
  CHECK(neededSamples(0, 0, 0.1) == 0);
  CHECK(std::isinf(neededSamples(INFINITY, 0.5, 0.1)));
}

TEST_CASE("adaptive: the variance of a half-region is that of the other half, relative to its brightness") {
  // Pixels of one half alternate between 2 and 4, those of the other half are always 1.
  const Light light = [](std::uint32_t x, std::uint32_t y, std::uint32_t i) {
    return halfOf(x, y) == 0 ? 2.0 + 2.0 * (i % 2) : 1.0;
  };
  image::Film film(16, 16);
  fill(film, {}, 100, light);
  const AdaptiveRegions regions({0, 0, 16, 16});
  const std::vector<double> variances = regions.variancesOf(film);
  REQUIRE(variances.size() == 2);
  CHECK(variances[0] == Approx(0).margin(1e-8));
  CHECK(variances[1] == Approx(100.0 / 99 / 9.01).epsilon(1e-6));
}

TEST_CASE("adaptive: deviations are power means over the same halves of the block's regions nearby") {
  // Two blocks of 4 x 1 regions. The white halves of the first one have the variances 1, 0, 256 and 256.
  const AdaptiveRegions regions({0, 0, 128, 16});
  std::vector<double> variances(16, 1);
  variances[2] = 0;
  variances[4] = variances[6] = 256;
  const std::vector<double> deviations = regions.smoothedDeviations(variances);
  CHECK(deviations[0] == Approx(std::pow((1 + 0.25 * (0 + 2)) / 1.5, 4)));
  CHECK(deviations[2] == Approx(std::pow((0 + 0.25 * (1 + 2 + 2)) / 1.75, 4)));
  CHECK(deviations[4] == Approx(std::pow((2 + 0.25 * (1 + 0 + 2)) / 1.75, 4)));
  CHECK(deviations[6] == Approx(std::pow((2 + 0.25 * (0 + 2)) / 1.5, 4)));
  for (const std::size_t other : {1u, 3u, 5u, 7u, 8u, 10u}) CHECK(deviations[other] == Approx(1));
}

TEST_CASE("adaptive: smoothing reaches two rows and columns, and leaves out halves without an estimate") {
  const AdaptiveRegions regions({0, 0, 64, 64});
  std::vector<double> variances(32, INFINITY);
  variances[0] = 256;
  const std::vector<double> deviations = regions.smoothedDeviations(variances);
  const auto deviationAt = [&](std::size_t column, std::size_t row) { return deviations[2 * (4 * row + column)]; };
  CHECK(deviationAt(0, 0) == Approx(16));
  CHECK(deviationAt(2, 2) == Approx(16));
  CHECK(std::isinf(deviationAt(3, 0)));
  CHECK(std::isinf(deviationAt(0, 3)));
  CHECK(std::isinf(deviations[1]));
}

TEST_CASE("adaptive: a pixel belongs to the same half in every crop") {
  const AdaptiveRegions whole({0, 0, 128, 128});
  const AdaptiveRegions crop({64, 64, 64, 64});
  for (std::uint32_t x = 0; x < 32; ++x) CHECK(whole.halfRegionAt(64 + x, 67) % 2 == crop.halfRegionAt(x, 3) % 2);
}

TEST_CASE("adaptive: regions stop at the first level that is not below the number of samples that they need") {
  // Relative variances of one sample are 0, 0.4 and 29, so that 0, 40 and 725 samples are needed.
  const Extent size{192, 64};
  const image::Film film = sampled(AdaptivePlan(windowOf(size), 0.2, 512), size, [](auto x, auto y, auto i) {
    const double mean = x < 64 ? 1 : x < 128 ? 1.4 : 30;
    return mean * (uniformAt(1, x, y, i) < 1 / mean);
  });
  CHECK(countAt(film, 5, 5) == 16);
  CHECK(countAt(film, 63, 63) == 16);
  CHECK(countAt(film, 64, 63) == 64);
  CHECK(countAt(film, 127, 5) == 64);
  CHECK(countAt(film, 128, 5) == 512);
  CHECK(countAt(film, 191, 5) == 512);
}

TEST_CASE("adaptive: only the samples of the other half decide when a half stops") {
  const Extent size{64, 64};
  const AdaptivePlan plan(windowOf(size), 0.2, 64);
  const image::Film film = sampled(plan, size, [](auto x, auto y, auto i) {
    return halfOf(x, y) == 0 ? 100.0 * (uniformAt(2, x, y, i) < 0.01) : 1.0;
  });
  for (std::uint32_t x = 0; x < 64; ++x) CHECK(countAt(film, x, 9) == (halfOf(x, 9) == 0 ? 16 : 64));
}

TEST_CASE("adaptive: regions near noisy ones get more samples, within their block") {
  const Extent size{128, 64};
  const AdaptivePlan plan(windowOf(size), 0.2, 64);
  // A region of little noise in the middle of the first block, and one at the edge of the second block. All other
  // regions of the first block are noisy.
  const image::Film film = sampled(plan, size, [](auto x, auto y, auto i) {
    const bool isQuiet = x >= 64 || (x / 16 == 1 && y / 16 == 1);
    return isQuiet ? 0.9 + 0.2 * (i % 2) : 100.0 * (uniformAt(3, x, y, i) < 0.01);
  });
  CHECK(countAt(film, 50, 20) == 64);
  CHECK(countAt(film, 20, 20) == 64);
  CHECK(countAt(film, 64, 20) == 16);  // another block
}

TEST_CASE("adaptive: black regions stop after the pilot") {
  const Extent size{64, 64};
  const AdaptivePlan plan(windowOf(size), 0.001, 1u << 20);
  image::Film film(64, 64);
  fill(film, {}, 16, [](auto, auto, auto) { return 0.0; });
  CHECK(AdaptivePlan(windowOf(size), 0.2, 256).next(film) == std::nullopt);
  CHECK(plan.next(film)->sampleEnd == pilotSamples(0.001));
}

TEST_CASE("adaptive: halves of too few pixels decide nothing") {
  const Extent size{65, 3};
  const image::Film film = sampled(AdaptivePlan(windowOf(size), 0.2, 32), size, [](auto, auto, auto) { return 1.0; });
  CHECK(countAt(film, 0, 0) == 32);
  CHECK(countAt(film, 64, 0) == 32);
}

TEST_CASE("adaptive: a film that was stopped anywhere continues to the same counts and sums") {
  const Extent size{96, 80};
  const AdaptivePlan plan(windowOf(size), 0.2, 200);
  const Light light = [](auto x, auto y, auto i) {
    const double mean = x < 40 ? 6.0 : y < 64 ? 2.5 : 1.0;
    return mean * (uniformAt(4, x, y, i) < 1 / mean);
  };
  const image::Film whole = sampled(plan, size, light);
  CHECK(summarise(plan, whole).halfRegions.size() > 2);
  image::Film film(size.width, size.height);
  std::mt19937 random(5);
  while (const auto step = plan.next(film)) {
    fill(film, step->pixels, step->indivisible, light);
    // Some pixels get all their samples, some get a few of them, and then the plan examines the film again.
    PixelMask chosen = step->pixels;
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = chosen[i] && random() % 3 == 0;
    fill(film, chosen,
         step->indivisible + static_cast<std::uint32_t>(random() % (step->sampleEnd - step->indivisible + 1)), light);
    if (random() % 4 == 0) fill(film, step->pixels, step->sampleEnd, light);
  }
  CHECK(film.hash() == whole.hash());
}

TEST_CASE("adaptive: crops of whole blocks decide like the image") {
  const Extent size{160, 96};
  const Light light = [](auto x, auto y, auto i) { return 1 + (x / 8 % 3) * 10 * (uniformAt(6, x, y, i) < 0.02); };
  const image::Film whole = sampled(AdaptivePlan(windowOf(size), 0.2, 128), size, light);
  const Window window{64, 0, 96, 64};
  requireAligned(window, size);
  const image::Film crop = sampled(AdaptivePlan(window, 0.2, 128), window.extent(),
                                   [&](auto x, auto y, auto i) { return light(window.x + x, window.y + y, i); });
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 96; ++x) REQUIRE(countAt(crop, x, y) == countAt(whole, 64 + x, y));
  }
}

TEST_CASE("adaptive: a finished film that is continued to a higher maximum equals one with it from the start") {
  const Extent size{64, 64};
  const Light light = [](auto x, auto y, auto i) { return x < 20 ? 30 * (uniformAt(7, x, y, i) < 0.03) : 1.0; };
  const image::Film whole = sampled(AdaptivePlan(windowOf(size), 0.2, 400), size, light);
  image::Film film = sampled(AdaptivePlan(windowOf(size), 0.2, 100), size, light);
  const AdaptivePlan more(windowOf(size), 0.2, 400);
  while (const auto step = more.next(film)) fill(film, step->pixels, step->sampleEnd, light);
  CHECK(film.hash() == whole.hash());
}

TEST_CASE("adaptive: crops that are not aligned are refused") {
  CHECK_NOTHROW(requireAligned({64, 0, 36, 64}, {100, 80}));
  CHECK_THROWS_AS(requireAligned({32, 0, 64, 64}, {128, 128}), UsageError);
  CHECK_THROWS_AS(requireAligned({0, 0, 64, 60}, {128, 128}), UsageError);
}

namespace {

/// Means over films of one region with independent noise: of all pixels, and of the estimated squared error.
struct Simulation {
  double mean = 0, meanError = 0;    ///< of the films' means, and the standard error of their mean
  double estimate = 0, squared = 0;  ///< mean squared relative error, estimated and actual
};

// `probability` is that with which a sample has the value 1 / probability, so that the mean is 1.
Simulation simulate(double probability, double threshold, std::uint32_t runs) {
  const Extent size{16, 16};
  const AdaptivePlan plan(windowOf(size), threshold, 1024);
  Simulation result;
  double squares = 0;
  for (std::uint32_t run = 0; run < runs; ++run) {
    std::minstd_rand random(run + 1);
    const std::uint64_t limit = static_cast<std::uint64_t>(probability * 2147483646.0);
    const image::Film film = sampled(plan, size,
                                     [&](auto, auto, auto) { return random() <= limit ? 1 / probability : 0.0; });
    double mean = 0;
    for (std::uint32_t y = 0; y < 16; ++y) {
      for (std::uint32_t x = 0; x < 16; ++x) {
        mean += film.mean(x, y).x / 256;
        result.squared += std::pow(film.mean(x, y).x - 1, 2) / 256 / runs;
      }
    }
    result.mean += mean / runs;
    squares += mean * mean / runs;
    result.estimate += std::pow(summarise(plan, film).meanError, 2) / runs;
  }
  result.meanError = std::sqrt((squares - result.mean * result.mean) / runs);
  return result;
}

}  // namespace

TEST_CASE("adaptive: stopping by the other half does not change the mean") {
  // Frequent light, light of the caustics, and rare light that half of the pilots of half-regions do not sample.
  for (const auto& [probability, threshold] : {std::pair{0.2, 0.1}, std::pair{0.01, 0.5}, std::pair{4e-4, 2.0}}) {
    const Simulation result = simulate(probability, threshold, 400);
    INFO(probability << ": mean " << result.mean << " +- " << result.meanError << ", squared error " << result.squared
                     << ", estimate " << result.estimate);
    CHECK(std::abs(result.mean - 1) < 4 * result.meanError);
    // Light that pilots do not sample is not in the estimate either.
    if (probability > 0.001) CHECK(result.estimate == Approx(result.squared).epsilon(0.03));
  }
}
