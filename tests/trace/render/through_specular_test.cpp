// Layers behind perfect mirrors and smooth glass.
#include <catch2/catch.hpp>

#include "host/scene/object_names.h"
#include "tests/trace/render/film_channels.h"

using namespace candela;
using namespace candela::device;

namespace {

using glm::dvec3;

// The eye looks down from z = 4 at the floor z = 0, whose material is given. Above the eye, at z = 10, is a ceiling
// over x > 0.
scene::Scene roomWith(const std::string& floor) {
  return sceneFromText("b .25 .5 1\nv\nfrom 0 0 4\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 12 12\nf " +
                       floor +
                       "\np 4\n-50 -40 0\n60 -40 0\n60 50 0\n-50 50 0\n"
                       "f .8 .4 .2 1 0 0 0 0 1 0 1 0 0 0\np 4\n0 -50 10\n0 50 10\n50 50 10\n50 -50 10\n");
}

const std::string kMirror = ".9 .9 .9 0 1 1 1 1 1 0 1 0 0 0";

render::RenderSettings throughSettings(std::uint32_t side) {
  render::RenderSettings settings = centreSettings(side);
  settings.image.layersThroughSpecular = true;
  return settings;
}

std::uint32_t onlyIdOf(const image::Film& film, std::uint32_t x, std::uint32_t y) {
  const image::IdCounts& counts = film.idsAt(image::MatteKind::object, x, y);
  REQUIRE(counts.size() == 1);
  return counts[0].id;
}

}  // namespace

TEST_CASE("behind a perfect mirror, layers show the surface that it reflects, at the length of the path") {
  const scene::Scene scene = roomWith(kMirror);
  REQUIRE(scene.materials[0].mirror);
  onBothTracers([&](const RenderFunction& render) {
    const image::Film film = render(scene, throughSettings(12)).film;
    const Channels channels(film);
    for (std::uint32_t y = 0; y < 12; ++y) {
      for (std::uint32_t x = 6; x < 12; ++x) {
        const dvec3 position = channels.vectorAt("P", "XYZ", x, y);
        CHECK(position.z == Approx(10).epsilon(1e-5));
        CHECK(position.x > 0);
        CHECK(channels.at("Z", x, y) == Approx(length(dvec3(position.x, position.y, 14))).epsilon(1e-5));
        CHECK(length(channels.vectorAt("N", "XYZ", x, y) - dvec3(0, 0, -1)) < 1e-5);
        CHECK(channels.at("albedo.G", x, y) == Approx(0.4));
        CHECK(onlyIdOf(film, x, y) == image::matteId("triangle.1"));
      }
    }
  });
}

TEST_CASE(
    "a path that leaves the scene behind a mirror has no hit in layers, and without the option that of the mirror") {
  const scene::Scene scene = roomWith(kMirror);
  onBothTracers([&](const RenderFunction& render) {
    const image::Film through = render(scene, throughSettings(12)).film;
    const Channels behind(through);
    CHECK(behind.at("Z", 2, 6) == Approx(1e10));
    CHECK(behind.vectorAt("N", "XYZ", 2, 6) == dvec3(0));
    CHECK(onlyIdOf(through, 2, 6) == image::kNoId);
    const image::Film plain = render(scene, centreSettings(12)).film;
    const Channels mirror(plain);
    CHECK(mirror.vectorAt("P", "XYZ", 2, 6).z == Approx(0).margin(1e-5));
    CHECK(mirror.vectorAt("N", "XYZ", 9, 6).z == Approx(1));
    CHECK(onlyIdOf(plain, 9, 6) == image::matteId("triangle.0"));
    CHECK(through.hash() == plain.hash());
  });
}

TEST_CASE("surfaces that are not only mirrors or glass are shown") {
  const std::string diffuse = ".5 .5 .5 1 0 0 0 0 1 0 1 0 0 0";
  const std::string diffuseAndGlossy = ".5 .5 .5 .5 .5 .5 .5 .5 40 0 1 0 0 0";
  const std::string diffuseAndGlass = ".5 .5 .5 .5 .5 .5 .5 .2 1 .5 1.5 0 0 0";
  onBothTracers([&](const RenderFunction& render) {
    for (const std::string& floor : {diffuse, diffuseAndGlossy, diffuseAndGlass}) {
      CAPTURE(floor);
      const image::Film film = render(roomWith(floor), throughSettings(6)).film;
      CHECK(onlyIdOf(film, 4, 3) == image::matteId("triangle.0"));
      CHECK(Channels(film).at("Z", 4, 3) < 5);
    }
  });
}

TEST_CASE("through panes of glass that do not refract, layers are those without the panes", "[swiftshader-slow]") {
  const std::string wall = "f .8 .4 .2 1 0 0 0 0 1 0 1 0 0 0\np 4\n-9 -9 0\n9 -9 0\n9 9 0\n-9 9 0\ns 0 0 .5 1\n";
  const std::string view = "b 0 0 0\nv\nfrom 0 0 4\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 12 12\n";
  const scene::Scene open = sceneFromText(view + wall);
  const scene::Scene glazed = sceneFromText(view + wall + "f 1 1 1 0 0 0 0 0 1 1 1 0 0 0\ns 0 0 3 .5\n");
  REQUIRE(glazed.materials[1].dielectric);
  onBothTracers([&](const RenderFunction& render) {
    const image::Film expected = render(open, centreSettings(12)).film;
    const image::Film film = render(glazed, throughSettings(12)).film;
    CHECK(film.ids(image::MatteKind::object) == expected.ids(image::MatteKind::object));
    const Channels a(expected), b(film);
    for (const char* name : {"N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "Z", "albedo.R"}) {
      CHECK(b.at(name, 6, 5) == Approx(a.at(name, 6, 5)).margin(1e-4));
      CHECK(b.at(name, 3, 4) == Approx(a.at(name, 3, 4)).margin(1e-4));
    }
  });
}

TEST_CASE("layers are seen through smooth interfaces, but not through rough ones") {
  using enum scene::Interface;
  scene::Scene scene = roomWith(kMirror);
  scene.materials[0] = {};
  onBothTracers([&](const RenderFunction& render) {
    for (const bool isMetal : {true, false}) {
      for (const scene::Interface shape : {smooth, beckmann}) {
        scene.materials[0].surface = scene::SurfaceParameters{.metalness = isMetal ? 1.0f : 0.0f,
                                                              .roughness = 0.3f,
                                                              .ior = 3,
                                                              .transmissionWeight = isMetal ? 0.0f : 1.0f,
                                                              .isThinWalled = false,
                                                              .bareInterface = shape};
        const image::Film film = render(scene, throughSettings(6)).film;
        const image::IdCounts& ids = film.idsAt(image::MatteKind::object, 4, 3);
        const bool showsFloor = ids.size() == 1 && ids[0].id == image::matteId("triangle.0");
        CAPTURE(isMetal, static_cast<int>(shape));
        CHECK(showsFloor == (shape == beckmann));
      }
    }
  });
}

TEST_CASE("neither the film nor the parts of the light depend on what layers are seen through", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("smallpt.p3f");
  onBothTracers([&](const RenderFunction& render) {
    render::RenderSettings settings = layerSettings(24, 6);
    const image::Film plain = render(scene, settings).film;
    settings.image.layersThroughSpecular = true;
    const image::Film through = render(scene, settings).film;
    CHECK(through.hash() == plain.hash());
    const Channels a(plain), b(through);
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.all().size(); ++i) {
      const std::string& name = a.all()[i].name;
      const bool isLight = name.starts_with("direct") || name.starts_with("indirect") || name.starts_with("emission");
      if (isLight) CHECK(a.all()[i].values == b.all()[i].values);
      different += a.all()[i].values == b.all()[i].values ? 0 : 1;
    }
    CHECK(different > 10);
  });
}

TEST_CASE("no division of the work changes layers behind mirrors and glass", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("smallpt.p3f");
  render::RenderSettings settings = layerSettings(20, 5);
  settings.image.layersThroughSpecular = true;
  const image::Film expected = renderOnDevice(scene, settings).film;
  SECTION("wavefront") { settings.execution.kernel = render::KernelKind::wavefront; }
  SECTION("wavefront of two rounds") {
    settings.execution.kernel = render::KernelKind::wavefront;
    settings.execution.segmentsPerDispatch = 2;
  }
  SECTION("one segment per dispatch") { settings.execution.segmentsPerDispatch = 1; }
  SECTION("mattes alone") {
    settings.execution.segmentsPerDispatch = 1;
    settings.image.layers = {};
    settings.image.layers.add(image::Layer::cryptoObject);
  }
  const image::Film film = renderOnDevice(scene, settings).film;
  if (film.layers() == expected.layers()) CHECK(film.layerRows() == expected.layerRows());
  CHECK(film.ids(image::MatteKind::object) == expected.ids(image::MatteKind::object));
}

TEST_CASE("both tracers see the same behind mirrors and glass") {
  const scene::Scene scene = loadTestScene("smallpt.p3f");
  render::RenderSettings settings = layerSettings(32, 4);
  settings.image.layersThroughSpecular = true;
  const image::Film onDevice = renderOnDevice(scene, settings).film;
  const image::Film expected = renderOnReference(scene, settings).film;
  std::size_t different = 0;
  const Channels a(onDevice), b(expected);
  for (std::uint32_t i = 0; i < 32 * 32; ++i) {
    const std::uint32_t x = i % 32, y = i / 32;
    const bool sameIds = onDevice.idsAt(image::MatteKind::object, x, y) ==
                         expected.idsAt(image::MatteKind::object, x, y);
    const bool sameDepth = std::abs(a.at("Z", x, y) - b.at("Z", x, y)) <= 1e-3 * b.at("Z", x, y);
    different += sameIds && sameDepth ? 0 : 1;
  }
  CHECK(different <= 10);  // of 1024 pixels
}
