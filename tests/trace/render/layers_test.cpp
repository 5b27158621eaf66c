// Layers: equal bytes for every division of a device's work.
#include <array>
#include <atomic>
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/trace/render/film_channels.h"

using namespace candela;
using namespace candela::device;

namespace {

std::array<std::vector<image::IdCounts>, 2> idsOf(const image::Film& film) {
  return {film.ids(image::MatteKind::object), film.ids(image::MatteKind::material)};
}

// Requires that `settings` change neither the film nor its layers.
void requireSameLayers(const scene::Scene& scene, const render::RenderSettings& settings, const image::Film& expected) {
  const image::Film film = renderOnDevice(scene, settings).film;
  CHECK(film.hash() == expected.hash());
  CHECK(film.layerRows() == expected.layerRows());
  CHECK(idsOf(film) == idsOf(expected));
}

render::RenderSettings divisionSettings() {
  render::RenderSettings settings = layerSettings(36, 4);
  settings.image.size.height = 29;  // not a multiple of any workgroup
  settings.image.maxDepth = 6;
  return settings;
}

}  // namespace

TEST_CASE("layers do not change the film, and films without layers have none", "[swiftshader-slow]") {
  for (const char* name : {"primitives.p3f", "sky.p3f"}) {
    const scene::Scene scene = loadTestScene(name);
    for (const render::KernelKind kernel : {render::KernelKind::megakernel, render::KernelKind::wavefront}) {
      render::RenderSettings settings = divisionSettings();
      settings.execution.kernel = kernel;
      const image::Film with = renderOnDevice(scene, settings).film;
      settings.image.layers = {};
      const image::Film without = renderOnDevice(scene, settings).film;
      CHECK(with.hash() == without.hash());
      CHECK(without.layerRows().empty());
    }
  }
}

TEST_CASE("no division of the work changes layers") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  const image::Film expected = renderOnDevice(scene, divisionSettings()).film;
  render::RenderSettings settings = divisionSettings();
  SECTION("wavefront") { settings.execution.kernel = render::KernelKind::wavefront; }
  SECTION("wavefront of two rounds") {
    settings.execution.kernel = render::KernelKind::wavefront;
    settings.execution.segmentsPerDispatch = 2;
  }
  SECTION("small tiles") { settings.execution.tile = render::Extent{7, 5}; }
  SECTION("one segment per dispatch") { settings.execution.segmentsPerDispatch = 1; }
  SECTION("bands of few rows") { settings.execution.maxBandBytes = 64 << 10; }
  requireSameLayers(scene, settings, expected);
}

TEST_CASE("a crop has the layers of the full image") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  onBothTracers([&](const RenderFunction& render) {
    render::RenderSettings settings = layerSettings(32, 2);
    const image::Film full = render(scene, settings).film;
    settings.image.crop = render::Window{5, 9, 11, 13};
    const image::Film crop = render(scene, settings).film;
    for (std::uint32_t y = 0; y < crop.height(); ++y) {
      for (std::uint32_t x = 0; x < crop.width(); ++x) {
        REQUIRE(std::ranges::equal(crop.layerRowsAt(x, y), full.layerRowsAt(5 + x, 9 + y)));
        REQUIRE(crop.idsAt(image::MatteKind::object, x, y) == full.idsAt(image::MatteKind::object, 5 + x, 9 + y));
      }
    }
  });
}

TEST_CASE("layers have the film's samples where a session was stopped, and continue from there", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  render::RenderSettings settings = divisionSettings();
  settings.execution.segmentsPerDispatch = 1;
  settings.execution.tile = render::Extent{16, 16};
  settings.execution.threads = 1;
  const auto check = [&](render::Renderer& renderer) {
    const image::Film whole = renderer.render(scene, settings, {}).film;
    std::atomic<bool> stop = false;
    const std::unique_ptr<render::Session> first = renderer.prepare(scene, settings);
    CHECK_FALSE(first->advance({0, 4}, {&stop, [&](double, std::uint64_t samples) { stop = samples > 900; }}));
    const image::Film partial = first->film();
    CHECK(partial.layerRows() != whole.layerRows());
    CHECK(std::ranges::all_of(partial.layerRows(), [](const image::LayerRow& row) { return row.pending == 0; }));
    const std::unique_ptr<render::Session> second = renderer.prepare(scene, settings);
    second->load(partial);
    CHECK(second->advance({0, 4}, {}));
    CHECK(second->film().layerRows() == whole.layerRows());
    CHECK(idsOf(second->film()) == idsOf(whole));
    stop = false;
    CHECK(first->advance({0, 4}, {}));
    CHECK(first->film().layerRows() == whole.layerRows());
    CHECK(idsOf(first->film()) == idsOf(whole));
  };
  SECTION("device") { check(testRenderer()); }
  SECTION("device, in bands") {
    check(*makeGpuRenderer(testDevice(), {.loopLimit = std::nullopt, .form = std::nullopt, .maxBandBytes = 64 << 10}));
  }
  SECTION("reference") { check(*reference::makeReferenceRenderer()); }
}

TEST_CASE("layers of parts of the samples add up to the layers of all") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  const render::RenderSettings settings = layerSettings(16, 6);
  const auto check = [&](render::Renderer& renderer) {
    const auto filmOf = [&](render::SampleRange range) {
      const std::unique_ptr<render::Session> session = renderer.prepare(scene, settings);
      CHECK(session->advance(range, {}));
      return session->film();
    };
    image::Film sum = filmOf({0, 2});
    sum.merge(filmOf({2, 6}));
    CHECK(sum.layerRows() == filmOf({0, 6}).layerRows());
    CHECK(idsOf(sum) == idsOf(filmOf({0, 6})));
  };
  SECTION("device") { check(testRenderer()); }
  SECTION("reference") { check(*reference::makeReferenceRenderer()); }
}

TEST_CASE("a session does not continue a film with other layers") {
  const scene::Scene scene = loadTestScene("mirror.p3f");
  onBothTracers([&](const RenderFunction& render) {
    render::RenderSettings settings = layerSettings(8, 2);
    const image::Film film = render(scene, settings).film;
    settings.image.layers = {};
    CHECK_THROWS_AS(testRenderer().prepare(scene, settings)->load(film), UsageError);
    CHECK_THROWS_AS(reference::makeReferenceRenderer()->prepare(scene, settings)->load(film), UsageError);
  });
}
