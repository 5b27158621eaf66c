// Tests which bright pixels are limited, and by how much.
#include "host/trace/denoise/isolated_samples.h"

#include <catch2/catch.hpp>

#include "tests/trace/denoise/made_films.h"

using namespace candela;
using namespace candela::denoise;

namespace {

constexpr std::uint32_t kSize = 9, kCentre = 4, kCount = 16;
constexpr MadePixel kEven{.radiance = glm::dvec3(1), .albedo = glm::dvec3(1), .noise = 0};

/// A film of equal samples of 1, except that `brightCount` of the 16 samples of the pixel in the middle are
/// `brightness`.
image::Film filmWith(std::uint32_t brightCount, double brightness, const MadePixel& around = kEven) {
  image::Film film = madeFilm(kSize, kSize, kCount, [&](auto, auto) { return around; });
  film.at(kCentre, kCentre) = {};
  std::ranges::fill(film.layerRowsAt(kCentre, kCentre), image::LayerRow{});
  MadePixel bright = kEven;
  bright.radiance = glm::dvec3(brightness);
  addMadeSamples(film, kCentre, kCentre, kEven, kCount - brightCount);
  addMadeSamples(film, kCentre, kCentre, bright, brightCount);
  return film;
}

struct Limited {
  gpu::DenoisePixel before{}, after{};
  LimitedLight light;

  double factor() const { return double{after.light.x} / double{before.light.x}; }
};

Limited limit(const image::Film& film) {
  constexpr std::size_t kIndex = kCentre * kSize + kCentre;
  PixelStatistics statistics = statisticsOf(film);
  Limited limited;
  limited.before = statistics.pixels[kIndex];
  limited.light = limitIsolatedSamples(statistics);
  limited.after = statistics.pixels[kIndex];
  return limited;
}

}  // namespace

TEST_CASE("one bright sample is limited to 8 times the neighbours, and the lost light is stated") {
  const Limited limited = limit(filmWith(1, 1601));
  CHECK(double{limited.before.light.x} == Approx(101));
  CHECK(double{limited.after.light.x} == Approx(8));
  CHECK(limited.light.pixelCount == 1);
  CHECK(limited.light.removedFraction == Approx(93.0 / (80 + 101)));
}

TEST_CASE("a limited pixel has the statistics of samples that are darker by one factor") {
  const Limited limited = limit(filmWith(1, 1601));
  const double factor = limited.factor();
  CHECK(double{limited.after.root.x} == Approx(double{limited.before.root.x} * std::sqrt(factor)));
  CHECK(double{limited.after.root.w} == Approx(double{limited.before.root.w} * factor));
  CHECK(limited.after.light.w == kCount);
  CHECK(limited.after.normal == limited.before.normal);
  CHECK(limited.after.reflectance == limited.before.reflectance);
}

TEST_CASE("the factor is that of the formula where several samples are bright") {
  // Three channels are equal: s = (12 + 4 * 40) / 16, u = (12 + 4 * 1600) / 16, and the neighbours have no variance.
  const double root = 172.0 / 16, light = 6412.0 / 16;
  const double statistic = (root - 1) * (root - 1) * 15 / (light - root * root) / 4;
  const double membership = (1.5 - statistic) / 1.2;
  REQUIRE(membership > 0.1);
  REQUIRE(membership < 0.9);
  CHECK(limit(filmWith(4, 1600)).factor() == Approx(1 - membership * (1 - 8 / light)));
}

TEST_CASE("a bright pixel stays where many of its samples are bright") {
  for (const std::uint32_t count : {7u, 16u}) {
    const Limited limited = limit(filmWith(count, 1600));
    CHECK(limited.factor() == 1);
    CHECK(limited.light.pixelCount == 0);
    CHECK(limited.light.removedFraction == 0);
  }
}

TEST_CASE("a bright sample stays if it makes its pixel less than 8 times as bright") {
  CHECK(limit(filmWith(1, 112)).light.pixelCount == 0);
  CHECK(limit(filmWith(1, 114)).light.pixelCount == 1);
}

TEST_CASE("neighbours of another surface do not count") {
  MadePixel otherNormal = kEven, otherAlbedo = kEven;
  otherNormal.normal = {1, 0, 0};
  otherAlbedo.albedo = glm::dvec3(0.2);
  CHECK(limit(filmWith(1, 1601, otherNormal)).light.pixelCount == 0);
  CHECK(limit(filmWith(1, 1601, otherAlbedo)).light.pixelCount == 0);
}

TEST_CASE("a black image has no isolated light") {
  MadePixel black = kEven;
  black.radiance = glm::dvec3(0);
  PixelStatistics statistics = statisticsOf(madeFilm(kSize, kSize, 4, [&](auto, auto) { return black; }));
  const LimitedLight limited = limitIsolatedSamples(statistics);
  CHECK(limited.pixelCount == 0);
  CHECK(limited.removedFraction == 0);
}
