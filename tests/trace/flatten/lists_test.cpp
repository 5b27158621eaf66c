// The structs, records and constants that are made from the lists, compared with defaults and lanes written by hand.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "host/scene/scene.h"
#include "host/trace/flatten/flatten_sections.h"

using namespace candela;

namespace {

glm::vec4 floats(const gpu::uvec4& row) { return std::bit_cast<glm::vec4>(row); }

flatten::Rows recordsOf(const scene::SurfaceParameters& surface) {
  scene::Scene scene;
  scene.materials.resize(1);
  scene.materials[0].surface = surface;
  return flatten::surfaceRows(scene, flatten::orderSurfaces(scene));
}

// Returns the features of a scene whose only light has this kind.
flatten::SceneFeatures featuresOf(flatten::LightKind kind) {
  flatten::SceneFeatures features;
  flatten::noteLights(std::vector<flatten::LightEntry>{{.kind = kind}}, {}, features);
  return features;
}

}  // namespace

TEST_CASE("the defaults of surface parameters are a rough white dielectric's") {
  const scene::SurfaceParameters surface;
  CHECK(surface.baseColour == glm::vec3(1));
  CHECK(surface.metalness == 0);
  CHECK(surface.specularColour == glm::vec3(1));
  CHECK(surface.specularWeight == 1);
  CHECK(surface.roughness == 1);
  const double r = (double{surface.ior} - 1) / (double{surface.ior} + 1);
  CHECK(r * r == Approx(0.04));  // reflectance at normal incidence of glTF's materials
  CHECK(surface.transmissionWeight == 0);
  CHECK(surface.transmissionDispersionScale == 0);
  CHECK(surface.isThinWalled);
  CHECK(surface.absorption == glm::vec3(0));
  CHECK(surface.coatWeight == 0);
  CHECK(surface.coatRoughness == 0);
  CHECK(surface.sheenColour == glm::vec3(0));
  CHECK(surface.sheenRoughness == 0);
  CHECK(surface.anisotropy == 0);
  CHECK(surface.anisotropyRotation == 0);
  CHECK(surface.filmWeight == 0);
  CHECK(surface.filmIor == 1.3f);
  CHECK(surface.filmThickness == 400);
  CHECK(surface.filmThicknessMinimum == 100);
  CHECK(!surface.conductor);
}

TEST_CASE("every surface parameter has lanes of its own in the records of a surface") {
  const scene::SurfaceParameters surface{.baseColour = {1, 2, 3},
                                         .metalness = 4,
                                         .specularColour = {5, 6, 7},
                                         .specularWeight = 8,
                                         .roughness = 9,
                                         .ior = 10,
                                         .transmissionWeight = 11,
                                         .transmissionDispersionScale = 12,
                                         .isThinWalled = false,
                                         .absorption = {13, 14, 15},
                                         .coatWeight = 16,
                                         .sheenColour = {17, 18, 19},
                                         .sheenRoughness = 20,
                                         .coatRoughness = 21,
                                         .anisotropy = 22,
                                         .filmWeight = 23,
                                         .filmIor = 24,
                                         .filmThickness = 25,
                                         .filmThicknessMinimum = 26,
                                         .anisotropyRotation = std::numbers::pi_v<float> / 3,
                                         .conductor = scene::Conductor{{27, 28, 29}, {30, 31, 32}}};
  const flatten::Rows rows = recordsOf(surface);
  REQUIRE(rows.size() == 10);
  CHECK(floats(rows[0]) == glm::vec4(1, 2, 3, 4));
  CHECK(floats(rows[1]) == glm::vec4(5, 6, 7, 8));
  CHECK(floats(rows[2]) == glm::vec4(9, 10, 11, 21));
  CHECK(floats(rows[3]) == glm::vec4(13, 14, 15, 16));
  CHECK(rows[4].x == 1);  // the first volume
  CHECK(floats(rows[4]).y == 22);
  CHECK(floats(rows[4]).z == Approx(0.5));
  CHECK(floats(rows[4]).w == Approx(std::sqrt(0.75)));
  CHECK(floats(rows[5]) == glm::vec4(17, 18, 19, 20));
  CHECK(floats(rows[6]) == glm::vec4(23, 24, 25, 26));
  CHECK(floats(rows[7]) == glm::vec4(27, 28, 29, 1));
  CHECK(floats(rows[8]) == glm::vec4(30, 31, 32, 12));
  CHECK(floats(rows[9]) == glm::vec4(0));
}

TEST_CASE("the transmittances of rough plastic follow the surfaces, with shared values at the ends of records") {
  scene::Plastic plastic{scene::Interface::beckmann, true, 0.5f, {}};
  for (std::size_t i = 0; i < plastic.transmittances.size(); ++i) plastic.transmittances[i] = static_cast<float>(i);
  scene::Scene scene;
  for (const scene::Interface boundary :
       {scene::Interface::ggx, scene::Interface::smooth, scene::Interface::beckmann}) {
    plastic.boundary = boundary;
    scene.materials.emplace_back().surface = scene::SurfaceParameters{.plastic = plastic};
  }
  const flatten::Rows rows = flatten::surfaceRows(scene, flatten::orderSurfaces(scene));
  REQUIRE(rows.size() == 3 * 10 + 2 * 21);
  CHECK(floats(rows[9]) == glm::vec4(2, 0.5f, 1, 30));
  CHECK(floats(rows[19]) == glm::vec4(1, 0.5f, 1, 51));
  CHECK(floats(rows[29]) == glm::vec4(3, 0.5f, 1, 51));
  CHECK(floats(rows[30]) == glm::vec4(0, 1, 2, 3));
  CHECK(floats(rows[52]) == glm::vec4(3, 4, 5, 6));
  CHECK(floats(rows[71]) == glm::vec4(60, 61, 62, 63));
}

TEST_CASE("the shape of a bare interface takes the place of plastic's, and thin walls are smooth") {
  using enum scene::Interface;
  scene::Scene scene;
  for (const scene::Interface shape : {smooth, ggx, beckmann, beckmann}) {
    scene.materials.emplace_back().surface = scene::SurfaceParameters{.bareInterface = shape};
  }
  scene.materials.back().surface->transmissionWeight = 1;
  const flatten::Rows rows = flatten::surfaceRows(scene, flatten::orderSurfaces(scene));
  REQUIRE(rows.size() == 4 * 10);
  CHECK(floats(rows[9]) == glm::vec4(4, 0, 0, 0));
  CHECK(floats(rows[19]) == glm::vec4(5, 0, 0, 0));
  CHECK(floats(rows[29]) == glm::vec4(6, 0, 0, 0));
  CHECK(floats(rows[39]) == glm::vec4(4, 0, 0, 0));
}

TEST_CASE("every texture slot and treatment of coordinates has a value of its own, from 0 on") {
  std::set<std::uint32_t> slots;
  std::set<std::uint32_t> wraps;
#define CANDELA_INSERT_SLOT(slot, name, value) slots.insert(gpu::name);
  CANDELA_TEXTURE_SLOTS(CANDELA_INSERT_SLOT)
#undef CANDELA_INSERT_SLOT
#define CANDELA_INSERT_WRAP(wrap, name, value) wraps.insert(gpu::name);
  CANDELA_TEXTURE_WRAPS(CANDELA_INSERT_WRAP)
#undef CANDELA_INSERT_WRAP
  CHECK(slots.size() == scene::kTextureSlotCount);
  CHECK(*slots.rbegin() == scene::kTextureSlotCount - 1);
  CHECK(wraps == std::set<std::uint32_t>{0, 1, 2});
}

TEST_CASE("each kind of light has its feature alone") {
  using flatten::LightKind;
  for (const LightKind kind : {LightKind::sphere, LightKind::triangle, LightKind::point, LightKind::punctual,
                               LightKind::spot, LightKind::directional, LightKind::environment}) {
    const flatten::SceneFeatures features = featuresOf(kind);
    const flatten::LightEntry entry{.kind = kind};
    CAPTURE(static_cast<int>(kind));
    CHECK(features.sphereLights == (kind == LightKind::sphere));
    CHECK(features.triangleLights == (kind == LightKind::triangle));
    CHECK(features.pointLights == (kind == LightKind::point));
    CHECK(features.punctualLights ==
          (kind == LightKind::punctual || kind == LightKind::spot || kind == LightKind::directional));
    CHECK(features.environmentLight == (kind == LightKind::environment));
    CHECK(entry.isEmitter() == (features.sphereLights || features.triangleLights));
    CHECK(entry.isPoint() == features.pointLights);
    CHECK(entry.isPunctual() == features.punctualLights);
    CHECK(entry.isEnvironment() == features.environmentLight);
  }
}
