// Values and colours of the layers that a viewer shows.
#include "host/app/view/shown_layer.h"

#include <catch2/catch.hpp>
#include <set>

#include "engine_support.h"
#include "host/image/cryptomatte.h"
#include "host/scene/object_names.h"

using namespace candela;
using namespace candela::view;
using image::Layer;

namespace {

constexpr std::uint32_t kWidth = 24, kHeight = 16;

// A film of the Cornell box with all layers.
const image::Film& filmWithLayers() {
  static const image::Film film = [] {
    render::RenderSettings settings = settingsOf({"cpu"});
    for (const Layer layer : shownLayers()) settings.image.layers.add(layer);
    return reference::makeReferenceRenderer()->render(*testScene(), settings, {}).film;
  }();
  return film;
}

Picture pictureOf(Layer layer) {
  Picture picture(kSize);
  showLayer(filmWithLayers(), layer, picture);
  return picture;
}

// The channels of EXR files, by the names of the layer.
std::vector<image::Channel> channelsOf(Layer layer) {
  image::Image image = toImage(filmWithLayers());
  addLayers(image, filmWithLayers());
  std::vector<image::Channel> channels;
  for (const std::string& name : layerChannelNames(layer)) {
    for (const image::Channel& channel : image.channels) {
      if (channel.name == name) channels.push_back(channel);
    }
  }
  return channels;
}

}  // namespace

TEST_CASE("the values of a shown layer are those of the channels of EXR files") {
  for (const Layer layer : {Layer::normal, Layer::albedo, Layer::depth, Layer::position, Layer::uv, Layer::direct,
                            Layer::indirect, Layer::emission}) {
    CAPTURE(shownName(layer));
    const Picture picture = pictureOf(layer);
    const std::vector<image::Channel> channels = channelsOf(layer);
    REQUIRE(!channels.empty());
    std::size_t unequal = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const float expected = c < channels.size() ? channels[c].values[i] : 0;
        unequal += picture.pixels[i][static_cast<int>(c)] != expected;
      }
      unequal += picture.pixels[i].w != kSamples;
    }
    CHECK(unequal == 0);
  }
}

TEST_CASE("the variance is shown as the relative standard error of the mean, beside its value") {
  image::Film film(2, 1);
  film.addSample(0, 0, glm::dvec3(1), 0);
  film.addSample(0, 0, glm::dvec3(3), 1);
  Picture picture({2, 1});
  showLayer(film, Layer::variance, picture);
  CHECK(picture.at(0, 0).x == Approx(0.5));  // sqrt(2 / 2) / 2
  CHECK(picture.at(0, 0).y == Approx(2));
  CHECK(picture.at(1, 0) == glm::vec4(0));
  showLayer(film, Layer::samples, picture);
  CHECK(picture.at(0, 0) == glm::vec4(2, 0, 0, 2));
}

TEST_CASE("a matte has the colours of its ids, weighted by coverage, and the names of its ids") {
  const Picture picture = pictureOf(Layer::cryptoMaterial);
  const auto names = scene::matteNamesById(*testScene(), image::MatteKind::material);
  REQUIRE(picture.ids.size() == picture.pixels.size());
  std::size_t mixed = 0;
  for (std::size_t i = 0; i < picture.ids.size(); ++i) {
    glm::vec3 expected(0);
    for (const image::IdCount& entry : picture.ids[i]) {
      CHECK((entry.id == image::kNoId || names.contains(entry.id)));
      expected += idColour(entry.id) * (static_cast<float>(entry.count) / kSamples);
    }
    mixed += picture.ids[i].size() > 1;
    CHECK(glm::distance(glm::vec3(picture.pixels[i]), expected) < 1e-6f);
  }
  CHECK(mixed > 0);
  CHECK(matteText({{image::matteId("material.0"), 1}, {image::matteId("material.1"), 3}}, names) ==
        "material.1 75 %, material.0 25 %");
  CHECK(matteText({{image::kNoId, 4}}, names) == "nothing 100 %");
}

TEST_CASE("ids have different colours that are not dark, and no id is black") {
  std::set<std::tuple<int, int, int>> colours;
  for (int i = 0; i < 200; ++i) {
    const glm::ivec3 colour(255.0f * idColour(image::matteId("material." + std::to_string(i))));
    CHECK(std::max({colour.x, colour.y, colour.z}) >= 150);
    colours.insert({colour.x, colour.y, colour.z});
  }
  CHECK(colours.size() == 200);
  CHECK(idColour(image::kNoId) == glm::vec3(0));
}

TEST_CASE("each layer has its colours") {
  const LayerRange range{{-1, 0, 10}, {1, 4, 10}, 5};
  const image::DisplayTransform display{image::ToneMap::aces, 1};
  const auto colour = [&](ShownLayer layer, const glm::vec3& value) {
    return glm::ivec3(toDisplay(value, coloursOf(layer, display, range, 16)));
  };
  CHECK(colour(Layer::normal, {0, 0, 1}) == glm::ivec3(128, 128, 255));
  CHECK(colour(Layer::normal, {-1, 1, 0}) == glm::ivec3(0, 255, 128));
  CHECK(colour(Layer::albedo, glm::vec3(0.5f)) == glm::ivec3(188));  // sRGB, without exposure
  CHECK(colour(Layer::depth, {5, 0, 0}) == glm::ivec3(128));
  CHECK(colour(Layer::depth, {1e10f, 0, 0}) == glm::ivec3(0));
  CHECK(colour(Layer::position, {0, 4, 10}) == glm::ivec3(128, 255, 0));
  CHECK(colour(Layer::position, {0, 0, 0}) == glm::ivec3(0));  // nothing was hit
  CHECK(colour(Layer::uv, {1.25f, -0.5f, 0}) == glm::ivec3(64, 128, 0));
  CHECK(colour(Layer::cryptoObject, {0.2f, 0.4f, 1}) == glm::ivec3(51, 102, 255));
  CHECK(colour(Layer::samples, {16, 0, 0}) == glm::ivec3(image::toDisplay({1, 0, 0}, {image::ToneMap::heat})));
  CHECK(colour(Layer::variance, {0.125f, 0, 0}) == glm::ivec3(image::toDisplay({1, 0, 0}, {image::ToneMap::heat})));
  for (const ShownLayer layer : {ShownLayer(), ShownLayer(Layer::direct)}) {
    CHECK(colour(layer, {0.1f, 0.2f, 0.3f}) == glm::ivec3(image::toDisplay({0.1f, 0.2f, 0.3f}, display)));
  }
}

TEST_CASE("the range has the pixels that hit something") {
  Picture picture({4, 1});
  picture.pixels = {{2, 5, 0, 1}, {1e10f, 0, 0, 1}, {4, -1, 0, 1}, {9, 9, 9, 0}};
  const LayerRange range = rangeOf(picture);
  CHECK(range.minimum == glm::vec3(2, -1, 0));
  CHECK(range.maximum == glm::vec3(4, 5, 0));
  CHECK(range.median == 4);
  CHECK(rangeOf(Picture({2, 2})).median == 1);
}

TEST_CASE("layers follow each other in both directions, with the picture between the last and the first") {
  ShownLayer layer;
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i <= shownLayers().size(); ++i) {
    seen.insert(shownName(layer));
    CHECK(nextLayer(nextLayer(layer, false), true) == layer);
    layer = nextLayer(layer, false);
  }
  CHECK(!layer);
  CHECK(seen.size() == shownLayers().size() + 1);
}

TEST_CASE("a layer selects the path tracer, and another integrator the picture") {
  const Choice depth = withIntegrator({"0"}, render::Integrator::depth);
  CHECK(withLayer(depth, Layer::uv) == Choice{"0", render::Integrator::path, Layer::uv});
  CHECK(withIntegrator({"0", render::Integrator::path, Layer::uv}, render::Integrator::ao) ==
        Choice{"0", render::Integrator::ao});
}

TEST_CASE("the engine shows a layer of both sides and compares it by channels") {
  Engine engine(testHooks(), {"0", render::Integrator::path, Layer::normal}, Mode::split);
  const EngineView view = waitFor(
      engine, [](const EngineView& each) { return each.difference.has_value() && finished(Side::reference)(each); });
  CHECK(view.sides[0].picture->pixels == pictureOf(Layer::normal).pixels);
  CHECK(!view.sides[0].picture->isLight);
  CHECK(view.difference->unequal == 0);

  engine.setChoice({"0", render::Integrator::path, Layer::cryptoObject});
  const EngineView matte = waitFor(engine, [](const EngineView& each) {
    return each.choice.layer == Layer::cryptoObject && finished(Side::device)(each);
  });
  CHECK(matte.sides[0].picture->pixels == pictureOf(Layer::cryptoObject).pixels);
  REQUIRE(matte.matteNames);
  CHECK(matte.matteNames->size() > 1);
}

TEST_CASE("values that are not light differ by the channel that differs most") {
  Picture a({2, 1}), b({2, 1});
  a.isLight = b.isLight = false;
  a.pixels = {{0, 0.5f, -0.5f, 1}, {1, 1e-9f, 0, 1}};
  b.pixels = {{0, -0.5f, 0.25f, 1}, {1, 2e-9f, 0, 1}};
  const PictureDifference difference = compare(a, b);
  CHECK(difference.worstDifference == Approx(1));
  CHECK(difference.unequal == 1);
  CHECK(difference.meanA == 0);
}
