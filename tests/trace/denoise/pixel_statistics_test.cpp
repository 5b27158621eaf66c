// The statistics of pixels, compared with values computed by hand.
#include "host/trace/denoise/pixel_statistics.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "host/base/errors.h"
#include "tests/trace/denoise/made_films.h"

using namespace candela;
using namespace candela::denoise;

namespace {

void addSample(image::Film& film, const glm::dvec3& radiance, const image::LayerSample& sample) {
  film.addSample(0, 0, radiance, film.at(0, 0).sampleCount);
  film.addLayers(0, 0, sample, radiance);
}

image::LayerSample hitOf(const glm::dvec3& albedo, const glm::dvec3& normal) {
  return {image::LayerSample::FirstHit{.normal = normal, .albedo = albedo}, std::nullopt, std::nullopt};
}

}  // namespace

TEST_CASE("the statistics of two samples equal those computed by hand") {
  image::Film film(1, 1, momentLayers());
  addSample(film, {4, 1, 0}, hitOf({0.5, 0.25, 0}, {0, 0, 1}));
  addSample(film, {16, 1, 0}, hitOf({0.5, 0.75, 0}, {0, 1, 0}));
  const gpu::DenoisePixel pixel = statisticsOf(film).pixels.front();
  // The means are 10, 1, 0 and those of the roots 3, 1, 0; the divisors 0.5, 0.5 and 0.01.
  CHECK(pixel.light.x == Approx(20));
  CHECK(pixel.light.y == Approx(2));
  CHECK(pixel.light.z == 0);
  CHECK(pixel.light.w == 2);
  CHECK(pixel.root.x == Approx(3 / std::sqrt(0.5)));
  CHECK(pixel.root.y == Approx(1 / std::sqrt(0.5)));
  // Variance of the roots 2 and 4 is 2, that of their mean 1, which is divided by 0.5.
  CHECK(pixel.root.w == Approx(2));
  CHECK(glm::vec3(pixel.normal) == glm::vec3(0, 0.5, 0.5));
  CHECK(pixel.normal.w == Approx(0.5));  // (2 - 2 * 0.5) / 2
  CHECK(glm::vec3(pixel.reflectance) == glm::vec3(0.5, 0.5, 0));
  CHECK(pixel.reflectance.w == Approx(0.0625));  // variance of 0.25 and 0.75 is 0.125
  CHECK(divisorOf(pixel.reflectance) == glm::vec3(0.5f, 0.5f, 0.01f));
}

TEST_CASE("samples that miss everything have the reflectance 1 and no normal") {
  image::Film film(1, 1, momentLayers());
  addSample(film, glm::dvec3(1), {});
  addSample(film, glm::dvec3(1), hitOf(glm::dvec3(0.5), {0, 0, 1}));
  const gpu::DenoisePixel pixel = statisticsOf(film).pixels.front();
  CHECK(glm::vec3(pixel.reflectance) == glm::vec3(0.75));
  CHECK(pixel.reflectance.w == Approx(3 * 0.0625));
  CHECK(pixel.normal.z == 0.5f);
  CHECK(pixel.normal.w == Approx(0.25));
}

TEST_CASE("statistics of a film with a scale are those of its samples") {
  image::Film plain(1, 1, momentLayers()), scaled(1, 1, momentLayers(), 7);
  for (image::Film* const film : {&plain, &scaled}) {
    addSample(*film, {4, 1, 0}, hitOf({0.5, 0.25, 0}, {0, 0, 1}));
    addSample(*film, {16, 1, 0}, hitOf({0.5, 0.75, 0}, {0, 1, 0}));
  }
  const gpu::DenoisePixel a = statisticsOf(plain).pixels.front(), b = statisticsOf(scaled).pixels.front();
  for (int i = 0; i < 4; ++i) {
    CHECK(b.light[i] == Approx(a.light[i]));
    CHECK(b.root[i] == Approx(a.root[i]));
    CHECK(b.reflectance[i] == a.reflectance[i]);
  }
}

TEST_CASE("a pixel with one sample has no statistics") {
  image::Film film(1, 1, momentLayers());
  addSample(film, glm::dvec3(1), hitOf(glm::dvec3(0.5), {0, 0, 1}));
  CHECK(statisticsOf(film).pixels.front().light.w == 0);
}

TEST_CASE("films without the sums or with one sample are refused, with the remedy") {
  CHECK_THROWS_WITH(requireStatistics(image::Film(2, 2)), Catch::Contains("aov = moments or denoise"));
  image::LayerSet guides;
  guides.add(image::Layer::normal);
  guides.add(image::Layer::albedo);
  CHECK_THROWS_AS(requireStatistics(image::Film(2, 2, guides)), UsageError);
  const auto anything = [](auto, auto) { return MadePixel{}; };
  CHECK_THROWS_WITH(requireStatistics(madeFilm(2, 2, 1, anything)), Catch::Contains("two samples per pixel"));
  CHECK_NOTHROW(requireStatistics(madeFilm(2, 2, 2, anything)));
}
