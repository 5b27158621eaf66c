// The film's sums, compared with values computed by hand.
#include "host/image/film.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "host/base/errors.h"

using namespace candela;
using namespace candela::image;

namespace {

constexpr double kInfiniteSample = std::numeric_limits<double>::infinity();
constexpr double kNanSample = std::numeric_limits<double>::quiet_NaN();

FilmPixel pixelOf(const glm::dvec3& radiance, std::uint32_t sampleIndex = 0) {
  Film film(1, 1);
  film.addSample(0, 0, radiance, sampleIndex);
  return film.at(0, 0);
}

struct Sample {
  std::uint32_t x, y, index;
  glm::dvec3 radiance;
};

std::vector<Sample> randomSamples(std::uint32_t width, std::uint32_t height, std::uint32_t perPixel) {
  std::mt19937 random(7);
  std::lognormal_distribution<double> radiance(0.0, 4.0);
  std::vector<Sample> samples;
  for (std::uint32_t i = 0; i < width * height * perPixel; ++i) {
    const std::uint32_t pixel = i / perPixel;
    const bool bad = random() % 50 == 0;
    samples.push_back({pixel % width,
                       pixel / width,
                       i % perPixel,
                       {radiance(random), bad ? kNanSample : radiance(random), radiance(random)}});
  }
  return samples;
}

}  // namespace

TEST_CASE("a film sample is its value times 2^40, truncated") {
  const FilmPixel pixel = pixelOf({1.0, std::ldexp(1.0, -40), 3.25 + std::ldexp(1.9, -40)});
  CHECK(pixel.red == FixedSum{0, 256, 0});  // 2^40 = 256 * 2^32
  CHECK(pixel.green == FixedSum{1, 0, 0});
  CHECK(pixel.blue == FixedSum{1, 832, 0});  // 3.25 * 256 = 832; 1.9 is truncated to 1
  CHECK(pixel.sampleCount == 1);
  CHECK(pixel.badCount == 0);
  CHECK(pixel.firstBadSample == 0);
  CHECK(pixelOf({std::ldexp(0.999, -40), 0, 0}).red == FixedSum{0, 0, 0});
}

TEST_CASE("the largest film sample is stored exactly") {
  const FilmPixel pixel = pixelOf({kFilmMaximum, std::nextafter(kFilmMaximum, 0.0), 0.5});
  CHECK(pixel.red == FixedSum{0, 1u << 28, 0});                 // 2^60
  CHECK(pixel.green == FixedSum{0xffffff80u, 0x0fffffffu, 0});  // 2^60 - 2^7: one unit in the last place less
  CHECK(pixel.badCount == 0);
}

TEST_CASE("the second moment is the squared luminance in the film's units") {
  CHECK(pixelOf({4, 4, 4}).luminanceSquared == FixedSum{0, 16 * 256, 0});
  // Luminance 2^20: the square is 2^40, times 2^40 is 2^80.
  CHECK(pixelOf({kFilmMaximum, kFilmMaximum, kFilmMaximum}).luminanceSquared == FixedSum{0, 0, 1u << 16});
  // Green alone: 0.7152^2 = 0.51151104.
  const FilmPixel green = pixelOf({0, 1, 0});
  const double square = std::ldexp(static_cast<double>(green.luminanceSquared[1]), -8) +
                        std::ldexp(static_cast<double>(green.luminanceSquared[0]), -40);
  CHECK(std::abs(square - 0.51151104) < 2e-12);
}

TEST_CASE("film sums carry into all three words") {
  Film film(1, 1);
  FilmPixel& pixel = film.at(0, 0);
  pixel.red = {0xffffffffu, 0xffffffffu, 6};
  pixel.green = {0xffffffffu, 0, 0};
  film.addSample(0, 0, {std::ldexp(1.0, -40), std::ldexp(3.0, -40), 0}, 0);
  CHECK(pixel.red == FixedSum{0, 0, 7});
  CHECK(pixel.green == FixedSum{2, 1, 0});

  Film sum(1, 1);
  for (std::uint32_t i = 0; i < 17; ++i) sum.addSample(0, 0, {kFilmMaximum, 0, 0}, i);
  CHECK(sum.at(0, 0).red == FixedSum{0, 1u << 28, 1});  // 17 * 2^60 = 2^64 + 2^60
  CHECK(sum.mean(0, 0).x == kFilmMaximum);
}

TEST_CASE("a film channel that is not a number, infinite or negative adds nothing and counts its sample once") {
  for (const double value : {kNanSample, kInfiniteSample, -kInfiniteSample, -1e-300, -5.0}) {
    CAPTURE(value);
    const FilmPixel pixel = pixelOf({value, 2, value}, 41);
    CHECK(pixel.red == FixedSum{0, 0, 0});
    CHECK(pixel.green == FixedSum{0, 512, 0});
    CHECK(pixel.blue == FixedSum{0, 0, 0});
    CHECK(pixel.sampleCount == 1);
    CHECK(pixel.badCount == 1);
    CHECK(pixel.firstBadSample == 42);
  }
}

TEST_CASE("a film channel above the maximum is clamped and counted") {
  const FilmPixel pixel = pixelOf({1e30, 1048576.0001, 1}, 0);
  CHECK(pixel.red == FixedSum{0, 1u << 28, 0});
  CHECK(pixel.green == FixedSum{0, 1u << 28, 0});
  CHECK(pixel.badCount == 1);
  CHECK(pixel.firstBadSample == 1);
}

TEST_CASE("a film of scale k adds samples times 2^-k, and its means and variances are those of the samples") {
  Film film(1, 1, {}, 5);
  film.addSample(0, 0, {32, 48, 0x1p25}, 0);
  film.addSample(0, 0, {96, 16, 0x1p25 + 4}, 1);
  CHECK(film.at(0, 0).red == FixedSum{0, 4 << 8, 0});
  CHECK(film.at(0, 0).badCount == 1);
  CHECK(film.at(0, 0).firstBadSample == 2);
  CHECK(film.mean(0, 0) == glm::dvec3(64, 32, 0x1p25));
  Film plain(1, 1);
  plain.addSample(0, 0, {1, 1.5, 0x1p20}, 0);
  plain.addSample(0, 0, {3, 0.5, 0x1p20}, 1);
  CHECK(film.luminanceVariance(0, 0) == 1024 * plain.luminanceVariance(0, 0));
  CHECK(film.luminanceVariance(0, 0) > 0);
}

TEST_CASE("the scale is part of a film's hash unless it is 0, and films of different scales are not merged") {
  Film plain(2, 2), scaled(2, 2, {}, 1), other(2, 2, {}, 2);
  CHECK(Film(2, 2, {}, 0).hash() == plain.hash());
  CHECK(scaled.hash() != plain.hash());
  CHECK(scaled.hash() != other.hash());
  CHECK_THROWS_WITH(scaled.merge(other), Catch::Contains("different scales"));
  scaled.merge(Film(2, 2, {}, 1));
  scaled.clear();
  CHECK(scaled.scale() == 1);
}

TEST_CASE("the largest scale has variances that single precision represents") {
  Film film(1, 1, {}, kMaxFilmScale);
  film.addSample(0, 0, glm::dvec3(0), 0);
  film.addSample(0, 0, glm::dvec3(1e30), 1);
  CHECK(film.mean(0, 0).x == 0x1p59);
  CHECK(std::isfinite(static_cast<float>(film.luminanceVariance(0, 0))));
}

TEST_CASE("negative zero is no bad sample") { CHECK(pixelOf({-0.0, 0.0, -0.0}).badCount == 0); }

TEST_CASE("a film remembers the lowest bad sample, whatever the order") {
  Film film(1, 1);
  film.addSample(0, 0, {1, 1, 1}, 2);
  film.addSample(0, 0, {kNanSample, 1, 1}, 9);
  film.addSample(0, 0, {1, -1, 1}, 5);
  film.addSample(0, 0, {1, 1, kInfiniteSample}, 7);
  CHECK(film.at(0, 0).firstBadSample == 6);
  CHECK(film.at(0, 0).badCount == 3);
  CHECK(film.at(0, 0).sampleCount == 4);

  Film other(1, 1);
  other.addSample(0, 0, {kNanSample, 1, 1}, 3);
  Film clean(1, 1);
  clean.merge(film);
  CHECK(clean.at(0, 0).firstBadSample == 6);
  film.merge(other);
  CHECK(film.at(0, 0).firstBadSample == 4);
  film.merge(Film(1, 1));
  CHECK(film.at(0, 0).firstBadSample == 4);
}

TEST_CASE("any order and any split of the samples gives the same film") {
  std::vector<Sample> samples = randomSamples(3, 2, 200);
  Film whole(3, 2);
  for (const Sample& s : samples) whole.addSample(s.x, s.y, s.radiance, s.index);

  std::mt19937 random(11);
  for (int round = 0; round < 10; ++round) {
    std::shuffle(samples.begin(), samples.end(), random);
    std::vector<Film> parts(1 + random() % 7, Film(3, 2));
    for (const Sample& s : samples) parts[random() % parts.size()].addSample(s.x, s.y, s.radiance, s.index);
    Film merged(3, 2);
    for (const Film& part : parts) merged.merge(part);
    CHECK(merged.hash() == whole.hash());
  }
}

TEST_CASE("the hash of a film depends on every field and on the size") {
  const auto changed = [](auto change) {
    Film film(2, 2);
    change(film.at(1, 1));
    return film.hash() != Film(2, 2).hash();
  };
  CHECK(changed([](FilmPixel& p) { p.red[0] = 1; }));
  CHECK(changed([](FilmPixel& p) { p.green[1] = 1; }));
  CHECK(changed([](FilmPixel& p) { p.blue[2] = 0x80000000u; }));
  CHECK(changed([](FilmPixel& p) { p.luminanceSquared[0] = 1; }));
  CHECK(changed([](FilmPixel& p) { p.sampleCount = 1; }));
  CHECK(changed([](FilmPixel& p) { p.badCount = 1; }));
  CHECK(changed([](FilmPixel& p) { p.firstBadSample = 1; }));
  CHECK(Film(2, 2).hash() != Film(4, 1).hash());
  CHECK(Film(2, 2).hash() == Film(2, 2).hash());
}

TEST_CASE("the hash is FNV-1a of the little-endian words") {
  // An empty film hashes eight zero bytes: eight times hash = (hash ^ 0) * prime, from the published offset basis.
  std::uint64_t expected = 14695981039346656037ull;
  for (int i = 0; i < 8; ++i) expected *= 1099511628211ull;
  CHECK(Film().hash() == expected);
}

TEST_CASE("film means and variances are those of the samples") {
  std::mt19937 random(3);
  std::gamma_distribution<double> radiance(0.5, 3.0);
  Film film(1, 1);
  std::vector<double> luminances;
  glm::dvec3 sum(0);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const glm::dvec3 sample(radiance(random), radiance(random), radiance(random));
    film.addSample(0, 0, sample, i);
    luminances.push_back(0.2126 * sample.x + 0.7152 * sample.y + 0.0722 * sample.z);
    sum += sample;
  }
  double mean = 0;
  for (const double y : luminances) mean += y / 1000;
  double variance = 0;
  for (const double y : luminances) variance += (y - mean) * (y - mean) / 999;

  CHECK(film.mean(0, 0).x == Approx(sum.x / 1000).epsilon(1e-11));
  CHECK(film.mean(0, 0).y == Approx(sum.y / 1000).epsilon(1e-11));
  CHECK(film.mean(0, 0).z == Approx(sum.z / 1000).epsilon(1e-11));
  CHECK(film.luminanceVariance(0, 0) == Approx(variance).epsilon(1e-9));
}

TEST_CASE("a film without samples is black and has no variance") {
  Film film(2, 1);
  CHECK(film.mean(1, 0) == glm::dvec3(0));
  CHECK(film.luminanceVariance(1, 0) == 0);
  film.addSample(0, 0, {3, 3, 3}, 0);
  CHECK(film.luminanceVariance(0, 0) == 0);
  for (std::uint32_t i = 1; i < 100; ++i) film.addSample(0, 0, {3, 3, 3}, i);
  CHECK(film.luminanceVariance(0, 0) >= 0);
  CHECK(film.luminanceVariance(0, 0) < 1e-12);
}

TEST_CASE("films of different sizes are refused and stay unchanged") {
  Film film(2, 1);
  CHECK_THROWS_AS(film.merge(Film(1, 2)), UsageError);
  film.at(1, 0).sampleCount = 0xfffffff0u;
  Film other(2, 1);
  other.at(0, 0).sampleCount = 1;
  other.at(1, 0).sampleCount = 16;
  const std::uint64_t before = film.hash();
  CHECK_THROWS_AS(film.merge(other), UsageError);
  CHECK(film.hash() == before);
  other.at(1, 0).sampleCount = 15;
  film.merge(other);
  CHECK(film.at(1, 0).sampleCount == 0xffffffffu);
}

TEST_CASE("hits add up with the samples, decide alpha, and are part of the hash unless there are none") {
  Film film(2, 1);
  for (std::uint32_t i = 0; i < 4; ++i) film.addSample(0, 0, glm::dvec3(1), i);
  const std::uint64_t without = film.hash();
  film.addHit(0, 0);
  CHECK(film.hash() != without);
  CHECK(film.alpha(0, 0) == 0.25);
  CHECK(film.alpha(1, 0) == 0);
  Film other = film;
  other.merge(film);
  CHECK(other.at(0, 0).hitCount == 2);
  CHECK(other.alpha(0, 0) == 0.25);
  film.at(0, 0).hitCount = 0;
  film.addHit(1, 0);
  Film moved = film;
  moved.at(1, 0).hitCount = 0;
  CHECK(moved.hash() == without);
  moved.addHit(0, 0);
  CHECK(moved.hash() != film.hash());
}
