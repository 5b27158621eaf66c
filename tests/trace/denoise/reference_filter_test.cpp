// Properties of the filter: the pixels that it preserves, and those that it averages.
#include "host/trace/denoise/reference_filter.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "host/trace/denoise/denoise.h"
#include "tests/trace/denoise/made_films.h"

using namespace candela;
using namespace candela::denoise;

namespace {

image::Image denoised(const image::Film& film) {
  image::Image image = image::toImage(film);
  denoise::denoise(image, film, filterByReference);
  return image;
}

// Mean and variance of the red channel of the pixels of some columns.
struct Spread {
  double mean = 0, variance = 0;
};

Spread spreadOf(const image::Image& image, std::uint32_t firstColumn, std::uint32_t endColumn) {
  double sum = 0, squares = 0, count = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = firstColumn; x < endColumn; ++x) {
      const double value = double{image.at(x, y).r};
      sum += value;
      squares += value * value;
      ++count;
    }
  }
  return {sum / count, squares / count - sum * sum / (count * count)};
}

}  // namespace

TEST_CASE("a constant image is unchanged, to the bit") {
  for (const double value : {0.0, 0.3, 1e4}) {
    const image::Film film = madeFilm(20, 17, 4, [&](auto, auto) {
      return MadePixel{.radiance = glm::dvec3(value), .albedo = glm::dvec3(0.5), .noise = 0};
    });
    CHECK(denoised(film).rgb == image::toImage(film).rgb);
  }
}

TEST_CASE("the variance of a flat region falls by a factor of 8, and its mean stays") {
  const image::Film film = madeFilm(48, 48, 8, [](auto, auto) { return MadePixel{}; });
  const Spread before = spreadOf(image::toImage(film), 0, 48), after = spreadOf(denoised(film), 0, 48);
  CHECK(after.variance * 8 < before.variance);
  CHECK(after.mean == Approx(before.mean).epsilon(0.01));
}

TEST_CASE("an edge between two materials survives, wherever only one of the statistics shows it") {
  const MadePixel bright{.radiance = glm::dvec3(1)};
  MadePixel otherLight = bright, otherAlbedo = bright, otherNormal = bright;
  otherLight.radiance = glm::dvec3(0.1);
  otherAlbedo.radiance = glm::dvec3(0.25);
  otherAlbedo.albedo = glm::dvec3(0.125);
  otherNormal.radiance = glm::dvec3(0.8);
  otherNormal.normal = {1, 0, 0};
  for (const MadePixel& other : {otherLight, otherAlbedo, otherNormal}) {
    const image::Film film = madeFilm(32, 24, 16, [&](std::uint32_t x, auto) { return x < 16 ? bright : other; });
    const image::Image before = image::toImage(film), after = denoised(film);
    // The columns beside the edge have the means of their sides, which the noise of 24 x 16 samples leaves uncertain.
    for (const std::uint32_t column : {15u, 16u}) {
      const std::uint32_t side = column < 16 ? 0 : 16;
      CHECK(spreadOf(after, column, column + 1).mean == Approx(spreadOf(before, side, side + 16).mean).epsilon(0.06));
      CHECK(spreadOf(after, column, column + 1).variance * 2 < spreadOf(before, column, column + 1).variance);
    }
  }
}

TEST_CASE("a texture stays as it is while its light is averaged") {
  const auto albedoAt = [](std::uint32_t x, std::uint32_t y) { return (x + y) % 2 == 0 ? 0.75 : 0.5; };
  const image::Film film = madeFilm(24, 24, 64, [&](std::uint32_t x, std::uint32_t y) {
    return MadePixel{.radiance = glm::dvec3(2 * albedoAt(x, y)), .albedo = glm::dvec3(albedoAt(x, y))};
  });
  const image::Image image = denoised(film);
  for (std::uint32_t x = 8; x < 16; ++x) CHECK(double{image.at(x, 12).r} == Approx(2 * albedoAt(x, 12)).epsilon(0.15));
}

TEST_CASE("the light of a bright sample is spread, and neither kept nor lost") {
  image::Film film = madeFilm(31, 31, 16, [](auto, auto) { return MadePixel{}; });
  addMadeSamples(film, 15, 15, {.radiance = glm::dvec3(100), .noise = 0}, 1);
  const image::Image before = image::toImage(film), after = denoised(film);
  CHECK(before.at(15, 15).r > 5);
  CHECK(after.at(15, 15).r < 2);
  CHECK(spreadOf(after, 0, 31).mean == Approx(spreadOf(before, 0, 31).mean).epsilon(0.01));
}

TEST_CASE("a sample that is thousands of times as bright as the others leaves no disc") {
  const auto film = [](double brightest) {
    image::Film made = madeFilm(31, 31, 16, [](auto, auto) { return MadePixel{}; });
    addMadeSamples(made, 15, 15, {.radiance = glm::dvec3(brightest), .noise = 0}, 1);
    return made;
  };
  const image::Image usual = denoised(film(1)), bright = denoised(film(1e4));
  for (const std::uint32_t x : {9u, 12u, 15u, 18u, 21u}) CHECK(bright.at(x, 15).r < 2 * usual.at(x, 15).r);
}

TEST_CASE("pixels with fewer than two samples keep their colour and give it to no other") {
  image::Film film = madeFilm(9, 9, 8, [](auto, auto) { return MadePixel{.noise = 0}; });
  film.at(4, 4) = {};
  std::ranges::fill(film.layerRowsAt(4, 4), image::LayerRow{});
  addMadeSamples(film, 4, 4, {.radiance = glm::dvec3(100), .noise = 0}, 1);
  const image::Image image = denoised(film);
  CHECK(image.at(4, 4) == glm::vec3(100));
  CHECK(image.at(3, 4) == glm::vec3(1));
}

TEST_CASE("a denoised image says so, and has no variances") {
  const image::Image image = denoised(madeFilm(2, 2, 2, [](auto, auto) { return MadePixel{}; }));
  CHECK(image.metadata.contains(kDenoisedMetadata));
  CHECK(image.luminanceVariance.empty());
}
