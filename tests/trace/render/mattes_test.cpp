// Mattes: every sample is counted once, by both tracers and for every division of a device's work.
#include <atomic>
#include <catch2/catch.hpp>

#include "host/scene/object_names.h"
#include "tests/trace/render/film_channels.h"

using namespace candela;
using namespace candela::device;

namespace {

constexpr image::MatteKind kKinds[]{image::MatteKind::object, image::MatteKind::material};

// More samples than a device's list of hits has.
render::RenderSettings matteSettings(std::uint32_t samples) {
  render::RenderSettings settings = squareSettings(12, samples);
  settings.image.layers.add(image::Layer::cryptoObject);
  settings.image.layers.add(image::Layer::cryptoMaterial);
  settings.image.maxDepth = 2;
  return settings;
}

bool sameIds(const image::Film& a, const image::Film& b) {
  return std::ranges::all_of(kKinds, [&](image::MatteKind kind) { return a.ids(kind) == b.ids(kind); });
}

std::uint32_t countOf(const image::IdCounts& counts, std::uint32_t id) {
  for (const image::IdCount& entry : counts) {
    if (entry.id == id) return entry.count;
  }
  return 0;
}

void requireAllCounted(const image::Film& film) {
  for (const image::MatteKind kind : kKinds) {
    REQUIRE(film.ids(kind).size() == film.pixels().size());
    for (std::size_t i = 0; i < film.pixels().size(); ++i) {
      REQUIRE(sampleCountOf(film.ids(kind)[i]) == film.pixels()[i].sampleCount);
    }
  }
}

}  // namespace

TEST_CASE("every sample has an id, for more samples than a list has, however the work is divided",
          "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  const image::Film expected = renderOnDevice(scene, matteSettings(75)).film;
  requireAllCounted(expected);
  render::RenderSettings settings = matteSettings(75);
  SECTION("wavefront") { settings.execution.kernel = render::KernelKind::wavefront; }
  SECTION("one segment per dispatch") { settings.execution.segmentsPerDispatch = 1; }
  SECTION("small tiles") { settings.execution.tile = render::Extent{5, 3}; }
  SECTION("bands of few rows") { settings.execution.maxBandBytes = 8 << 10; }
  SECTION("with sums of other layers") { settings.image.layers = allLayers(); }
  const image::Film film = renderOnDevice(scene, settings).film;
  CHECK(sameIds(film, expected));
  CHECK(film.hash() == expected.hash());
}

TEST_CASE("samples without antialiasing and a single sample have ids") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  onBothTracers([&](const RenderFunction& render) {
    for (const bool antialiasing : {false, true}) {
      render::RenderSettings settings = matteSettings(1);
      settings.image.antialiasing = antialiasing;
      requireAllCounted(render(scene, settings).film);
    }
  });
}

TEST_CASE("stopped sessions and ranges count every sample once") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  render::RenderSettings settings = matteSettings(70);
  settings.execution.segmentsPerDispatch = 1;
  settings.execution.threads = 1;
  settings.execution.tile = render::Extent{4, 4};
  const auto check = [&](render::Renderer& renderer) {
    const image::Film whole = renderer.render(scene, settings, {}).film;
    const std::unique_ptr<render::Session> session = renderer.prepare(scene, settings);
    std::atomic<bool> stop = false;
    CHECK_FALSE(session->advance({0, 70}, {&stop, [&](double, std::uint64_t samples) { stop = samples > 5000; }}));
    requireAllCounted(session->film());
    stop = false;
    CHECK(session->advance({0, 41}, {}));
    const std::unique_ptr<render::Session> second = renderer.prepare(scene, settings);
    second->load(session->film());
    CHECK(second->advance({41, 70}, {}));
    CHECK(sameIds(second->film(), whole));
    CHECK(session->advance({41, 42}, {}));
    CHECK(session->advance({42, 70}, {}));
    CHECK(sameIds(session->film(), whole));
  };
  SECTION("device") { check(testRenderer()); }
  SECTION("reference") { check(*reference::makeReferenceRenderer()); }
}

TEST_CASE("both tracers count the same ids where single precision decides the hit") {
  for (const char* name : {"cornell.p3f", "primitives.p3f", "balls.p3f"}) {
    const scene::Scene scene = loadTestScene(name);
    const image::Film onDevice = renderOnDevice(scene, matteSettings(16)).film;
    const image::Film expected = reference::makeReferenceRenderer()->render(scene, matteSettings(16), {}).film;
    for (const image::MatteKind kind : kKinds) {
      std::size_t different = 0;
      for (std::size_t i = 0; i < expected.pixels().size(); ++i) {
        different += onDevice.ids(kind)[i] == expected.ids(kind)[i] ? 0 : 1;
      }
      CHECK(different <= 1);  // of 144 pixels
    }
  }
}

TEST_CASE("a ball's coverage is its fraction of the image") {
  const scene::Scene scene = sceneFromText(
      "b 0 0 0\nv\nfrom 0 0 0\nat 0 1 0\nup 0 0 1\nangle 90\nhither 0\nresolution 12 12\n"
      "f 1 1 1 1 0 0 0 0 1 0 1 0 0 0\ns -9 2 0 1\nf 1 0 0 1 0 0 0 0 1 0 1 0 0 0\ns 0 4 0 2\n");
  CHECK(scene::objectName(scene, 1) == "sphere.1");
  onBothTracers([&](const RenderFunction& render) {
    const image::Film film = render(scene, matteSettings(256)).film;
    double covered = 0;
    for (const image::IdCounts& counts : film.ids(image::MatteKind::object)) {
      covered += countOf(counts, image::matteId("sphere.1")) / 256.0 / 144.0;
    }
    // The cone of rays that touch the ball has the tangent tan(asin(2/4)) = 1/sqrt(3) on a plane of side 2.
    CHECK(covered == Approx(3.14159265 / 3 / 4).margin(0.001));
    CHECK(countOf(film.idsAt(image::MatteKind::material, 6, 6), image::matteId("material.1")) == 256);
    CHECK(film.idsAt(image::MatteKind::object, 0, 0) == image::IdCounts{{image::kNoId, 256}});
  });
}
