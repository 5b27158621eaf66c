// The sums of layers, compared with values computed by hand.
#include "host/image/layers.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "host/base/errors.h"
#include "host/image/image.h"

using namespace candela;
using namespace candela::image;

namespace {

constexpr double kNotANumberHere = std::numeric_limits<double>::quiet_NaN();

LayerSet setOf(std::initializer_list<Layer> layers) {
  LayerSet set;
  for (const Layer layer : layers) set.add(layer);
  return set;
}

// The records of a pixel that received these samples.
std::vector<LayerRow> rowsOf(LayerSet layers, const std::vector<std::pair<LayerSample, glm::dvec3>>& samples) {
  const std::uint32_t sums = layerSumsOf(layers);
  std::vector<LayerRow> rows(layerRowCount(sums));
  for (const auto& [sample, radiance] : samples) addLayerSample(rows, sums, sample, radiance);
  return rows;
}

LayerSample hitAt(double depth) { return {LayerSample::FirstHit{.depth = depth}, std::nullopt, std::nullopt}; }

}  // namespace

TEST_CASE("a pixel has a header and a record for each channel of the sums that its layers need") {
  CHECK(layerRowCount(layerSumsOf({})) == 0);
  CHECK(layerRowCount(layerSumsOf(setOf({Layer::variance, Layer::samples}))) == 0);
  CHECK(layerRowCount(layerSumsOf(setOf({Layer::depth}))) == 2);
  CHECK(layerRowCount(layerSumsOf(setOf({Layer::normal, Layer::uv}))) == 6);
  CHECK(layerRowCount(layerSumsOf(setOf({Layer::indirect}))) == 4);
  CHECK(layerRowCount(layerSumsOf(setOf({Layer::direct, Layer::indirect, Layer::emission}))) == 7);
  const std::uint32_t sums = layerSumsOf(setOf({Layer::normal, Layer::depth, Layer::uv}));
  CHECK(firstLayerRow(sums, LayerSum::normal) == 1);
  CHECK(firstLayerRow(sums, LayerSum::depth) == 4);
  CHECK(firstLayerRow(sums, LayerSum::texCoord) == 5);
}

TEST_CASE("a layer's value is added in units of 2^-40, truncated towards 0, in two's complement") {
  const LayerSet position = setOf({Layer::position});
  const LayerSample sample{LayerSample::FirstHit{.position = {-1, std::ldexp(1.75, -40), -std::ldexp(1.75, -40)}},
                           std::nullopt, std::nullopt};
  const std::vector<LayerRow> rows = rowsOf(position, {{sample, glm::dvec3(0)}});
  CHECK(rows[1].words == FixedSum{0, 0xffffff00u, 0xffffffffu});
  CHECK(rows[2].words == FixedSum{1, 0, 0});
  CHECK(rows[3].words == FixedSum{0xffffffffu, 0xffffffffu, 0xffffffffu});
  CHECK(toSignedDouble(rows[1].words) == -1);
  CHECK(rows[0].words == FixedSum{1, 0, 0});
}

TEST_CASE("values that are not finite add 0 to layers, those beyond 2^20 are limited, and both are counted") {
  const std::vector<LayerRow> rows = rowsOf(
      setOf({Layer::depth}),
      {{hitAt(kNotANumberHere), glm::dvec3(0)}, {hitAt(1e9), glm::dvec3(0)}, {hitAt(kFilmMaximum), glm::dvec3(0)}});
  CHECK(toSignedDouble(rows[1].words) == 2 * kFilmMaximum);
  CHECK(rows[0].words == FixedSum{3, 2, 0});
}

TEST_CASE("a part of the light is the whole where the path ended before, and never more than the film adds") {
  const LayerSet light = setOf({Layer::direct, Layer::emission});
  const glm::dvec3 whole(3, kNotANumberHere, 2 * kFilmMaximum);
  const std::vector<LayerRow> rows = rowsOf(light, {{{std::nullopt, glm::dvec3(1, 1, 2e6), std::nullopt}, whole}});
  CHECK(toDouble(rows[1].words) == 1);
  CHECK(toDouble(rows[2].words) == 0);  // the film adds 0 as well
  CHECK(toDouble(rows[3].words) == kFilmMaximum);
  CHECK(toDouble(rows[4].words) == 3);
  CHECK(toDouble(rows[5].words) == 0);
  CHECK(toDouble(rows[6].words) == kFilmMaximum);
}

TEST_CASE("channels of layers divide by all samples or by the hits, and a pixel without hits is far away") {
  Film film(2, 1, setOf({Layer::normal, Layer::depth, Layer::position}));
  const LayerSample hit{LayerSample::FirstHit{.normal = {0, -1, 0}, .depth = 8, .position = {-3, 0, 5}}, {}, {}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    film.addSample(0, 0, glm::dvec3(0), i);
    film.addLayers(0, 0, i == 0 ? hit : LayerSample{}, glm::dvec3(0));
  }
  Image image = toImage(film);
  addLayers(image, film);
  const std::vector<std::string> names{"N.X", "N.Y", "N.Z", "Z", "P.X", "P.Y", "P.Z"};
  REQUIRE(image.channels.size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) CHECK(image.channels[i].name == names[i]);
  CHECK(image.channels[1].values == std::vector<float>{-0.25f, 0});
  CHECK(image.channels[3].values == std::vector<float>{8, 1e10f});
  CHECK(image.channels[4].values == std::vector<float>{-3, 0});
}

TEST_CASE("films with layers add up, and refuse films with other layers") {
  const LayerSet depth = setOf({Layer::depth});
  Film a(1, 1, depth), b(1, 1, depth), other(1, 1);
  a.addLayers(0, 0, hitAt(1.5), glm::dvec3(0));
  b.addLayers(0, 0, hitAt(2.25), glm::dvec3(0));
  a.merge(b);
  CHECK(toSignedDouble(a.layerRowsAt(0, 0)[1].words) == 3.75);
  CHECK(a.layerRowsAt(0, 0)[0].words[0] == 2);
  CHECK_THROWS_AS(a.merge(other), UsageError);
  a.clear();
  CHECK(a.layerRows() == Film(1, 1, depth).layerRows());
}

TEST_CASE("layers of light have the film's scale, and the others have none") {
  const LayerSet layers = setOf({Layer::depth, Layer::direct, Layer::indirect, Layer::emission, Layer::moments});
  Film plain(1, 1, layers), scaled(1, 1, layers, 3);
  const auto add = [](Film& film, double factor) {
    LayerSample sample{LayerSample::FirstHit{.albedo = glm::dvec3(0.5), .depth = 2e5}, factor * glm::dvec3(1, 2, 3),
                       factor * glm::dvec3(2, 4, 8)};
    film.addSample(0, 0, factor * glm::dvec3(3, 7, 10), 0);
    film.addLayers(0, 0, sample, factor * glm::dvec3(3, 7, 10));
  };
  add(plain, 1);
  add(scaled, 8);
  CHECK(plain.layerRows() == scaled.layerRows());
  Image a = toImage(plain), b = toImage(scaled);
  addLayers(a, plain);
  addLayers(b, scaled);
  REQUIRE(a.channels.size() == b.channels.size());
  for (std::size_t i = 0; i < a.channels.size(); ++i) {
    INFO(a.channels[i].name);
    const bool isRoot = a.channels[i].name.starts_with("sqrt");
    const bool isLight = isRoot || a.channels[i].name.find("direct") != std::string::npos ||
                         a.channels[i].name.starts_with("emission");
    const double factor = isRoot ? std::sqrt(8.0) : isLight ? 8 : 1;
    CHECK(b.channels[i].values[0] == Approx(factor * a.channels[i].values[0]));
    if (isLight) CHECK(a.channels[i].values[0] > 0);
  }
}

TEST_CASE("moments are means of square roots, and variances of albedo and normal, of two samples by hand") {
  Film film(2, 1, setOf({Layer::moments}));
  const auto add = [&](const glm::dvec3& radiance, const LayerSample& sample) {
    film.addSample(0, 0, radiance, 0);
    film.addLayers(0, 0, sample, radiance);
  };
  add({4, 9, -1}, {LayerSample::FirstHit{.normal = {0, 0, 1}, .albedo = {0.5, 0, 0}}, {}, {}});
  add({16, 9, 4e6}, {LayerSample::FirstHit{.normal = {1, 0, 0}, .albedo = {0, 0.25, 0}}, {}, {}});
  Image image = toImage(film);
  addLayers(image, film);
  const std::vector<std::string> names{"sqrt.R", "sqrt.G", "sqrt.B", "variance.albedo", "variance.N"};
  REQUIRE(image.channels.size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) CHECK(image.channels[i].name == names[i]);
  CHECK(image.channels[0].values == std::vector<float>{3, 0});
  CHECK(image.channels[1].values == std::vector<float>{3, 0});
  CHECK(image.channels[2].values == std::vector<float>{512, 0});  // what is negative adds 0, and 2^20 is the maximum
  CHECK(image.channels[3].values == std::vector<float>{0.15625f, 0});  // half of 0.5^2 + 0.25^2
  CHECK(image.channels[4].values == std::vector<float>{1, 0});
}
