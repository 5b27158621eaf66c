// Probabilities of lights, compared with values computed by hand.
#include "host/trace/flatten/light_table.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "host/formats/loading/scene_builder.h"

using namespace candela;

namespace {

// Two triangles of area 1/2 and 3/2 with equal emission, and with another one the box (0 0 0) (3 1 1).
scene::Scene lamps() {
  scene::Scene scene;
  scene.materials.resize(2);
  scene.materials[1].emission = {2, 2, 2};
  scene.meshes = {{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, 0, 1}, {0, 1, 1}}}};
  scene.primitives = {{scene::PrimitiveKind::triangle, 0, 0},
                      {scene::PrimitiveKind::triangle, 0, 1},
                      {scene::PrimitiveKind::triangle, 1, 1}};
  return scene;
}

// Divided by pi, of a point light of luminance 1 in the box of lamps().
constexpr double kPointFlux = std::numbers::pi * (9 + 1 + 1) / 4;
constexpr double kStep = 0x1p-23;  // resolution of the thresholds

}  // namespace

TEST_CASE("an environment is chosen by its mean luminance times the area of the scene, and no group by less than 1/5") {
  scene::Scene scene = lamps();
  for (const float radiance : {0.5f, 1e6f}) {
    scene.environment = scene::Environment{.name = "", .width = 4, .height = 2, .texels = {}, .weights = {}};
    scene.environment->texels.assign(8, glm::vec3(radiance));
    scene.environment->weights.assign(8, scene::Environment::kMeanWeight);
    const auto table = flatten::buildLightTable(scene, true).entries;
    REQUIRE(table.size() == 3);
    const double flux = (9 + 1 + 1) * double{radiance};
    CHECK(table[2].probability == Approx(0.2 + 0.6 * flux / (flux + 4)).margin(kStep));
    CHECK(table[2].probability <= 0.8f);
  }
}

TEST_CASE("emitters are chosen in proportion to area times emission") {
  const auto table = flatten::buildLightTable(lamps(), true).entries;
  REQUIRE(table.size() == 2);
  CHECK(table[0].index == 1);
  CHECK(table[0].probability == 0.25f);
  CHECK(table[0].threshold == 1u << 22);
  CHECK(table[1].threshold == 1u << 24);
  CHECK(table[1].probability == 0.75f);
}

TEST_CASE("groups of lights are chosen by the flux that the scene receives, and point lights alone by their colours") {
  scene::Scene scene = lamps();
  scene.pointLights = {{{0, 0, 5}, {1, 1, 1}}, {{0, 0, 6}, {3, 3, 3}}};
  const auto both = flatten::buildLightTable(scene, true).entries;
  REQUIRE(both.size() == 4);
  const double points = 0.2 + 0.6 * kPointFlux * 4 / (kPointFlux * 4 + 4);
  CHECK(both[0].probability == Approx((1 - points) / 4).margin(kStep));
  CHECK(both[1].probability == Approx((1 - points) * 3 / 4).margin(kStep));
  CHECK(both[2].probability == Approx(points / 4).margin(kStep));
  CHECK(both[3].probability == Approx(points * 3 / 4).margin(kStep));
  const auto pointsOnly = flatten::buildLightTable(scene, false).entries;
  REQUIRE(pointsOnly.size() == 2);
  CHECK(pointsOnly[0].isPoint());
  CHECK(pointsOnly[0].probability == 0.25f);
}

TEST_CASE("punctual lights are chosen by intensity, a directional one by irradiance times the square of its reach") {
  using Kind = scene::PunctualLight::Kind;
  scene::Scene scene = lamps();
  scene.pointLights = {{{0, 0, 5}, {1, 1, 1}}};
  scene.punctualLights = {{.kind = Kind::directional, .intensity = {0.5f, 0.5f, 0.5f}, .reach = 2},
                          {.kind = Kind::point, .intensity = {0, 0, 0}},
                          {.kind = Kind::spot, .intensity = {5, 5, 5}}};
  const auto table = flatten::buildLightTable(scene, true).entries;
  REQUIRE(table.size() == 6);
  const double points = 0.2 + 0.6 * (kPointFlux + 7) / (kPointFlux + 7 + 4);
  CHECK(table[2].isPoint());
  CHECK(table[2].probability == Approx(points / 8).margin(kStep));
  CHECK(table[3].kind == flatten::LightKind::directional);
  CHECK(table[3].probability == Approx(points * 2 / 8).margin(kStep));
  CHECK(table[4].kind == flatten::LightKind::punctual);
  CHECK(table[4].probability == 0);
  CHECK(table[5].kind == flatten::LightKind::spot);
  CHECK(table[5].probability == Approx(points * 5 / 8).margin(kStep));
  CHECK(flatten::buildLightTable(scene, false).entries.size() == 4);
}

TEST_CASE("a lamp beside a sun has a fifth of its equal part, and a lamp that is off has none") {
  using Kind = scene::PunctualLight::Kind;
  scene::Scene scene = lamps();
  scene.pointLights = {{{0, 0, 5}, {1, 1, 1}}};
  scene.punctualLights = {{.kind = Kind::directional, .intensity = glm::vec3(1e5f), .reach = 800},
                          {.kind = Kind::point, .intensity = {0, 0, 0}},
                          {.kind = Kind::spot, .intensity = {64, 64, 64}}};
  const auto table = flatten::buildLightTable(scene, false).entries;
  REQUIRE(table.size() == 4);
  // With the sun's weight as 1: 1/15, 1, 0 and 1/15.
  CHECK(table[0].probability == Approx(1.0 / 17).margin(kStep));
  CHECK(table[1].probability == Approx(15.0 / 17).margin(kStep));
  CHECK(table[2].probability == 0);
  CHECK(table[3].probability == Approx(1.0 / 17).margin(kStep));
}

TEST_CASE("emitters that cannot be sampled by area are not in the table") {
  scene::Scene scene = lamps();
  scene.cones.push_back({{0, 0, 0}, 1, {0, 0, 1}, 1});
  scene.primitives.push_back({scene::PrimitiveKind::cone, 0, 1});
  addTriangle(scene, {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}, 1);  // no area
  CHECK(flatten::buildLightTable(scene, true).entries.size() == 2);
}

TEST_CASE("thresholds ascend and end at 2^24 for any number of lights") {
  scene::Scene scene = lamps();
  for (std::uint32_t i = 0; i < 999; ++i) scene.primitives.push_back({scene::PrimitiveKind::triangle, i % 2, 1});
  const auto table = flatten::buildLightTable(scene, true).entries;
  double sum = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    sum += table[i].probability;
    if (i > 0) REQUIRE(table[i].threshold >= table[i - 1].threshold);
  }
  CHECK(table.back().threshold == 1u << 24);
  CHECK(sum == 1);
}

TEST_CASE("lights of a share below half a threshold are counted as unsampled") {
  scene::Scene scene = lamps();
  scene.materials.emplace_back().emission = glm::vec3(0x1p-24f);
  scene.materials.emplace_back();
  addTriangle(scene, {{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}}, 2);  // share of 2^-27
  addTriangle(scene, {{{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}}, 3);  // emits nothing
  const flatten::UnsampledLights emitters = flatten::unsampledLights(flatten::buildLightTable(scene, true));
  CHECK(emitters.emitters == 1);
  CHECK(emitters.others == 0);
  const auto tree = flatten::buildLightTable(scene, true, render::LightSelection::tree);
  CHECK(flatten::unsampledLights(tree).emitters == 0);

  // Half a threshold is 2^-25, and the lowest share a fifth of the mean.
  scene::Scene dots;
  dots.punctualLights.assign(8000000, {.intensity = glm::vec3(1)});
  dots.punctualLights[0].intensity = glm::vec3(1e9f);
  CHECK(flatten::unsampledLights(flatten::buildLightTable(dots, true)).others > 1000000);
}
