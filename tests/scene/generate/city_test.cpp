// The city: buildings on lots of their own, taller towards the centre; every model is stored once.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "host/scene/generate/city_plan.h"
#include "tests/scene/generate/generated_text.h"

namespace candela::generate {
namespace {

double heightOf(const BuildingPlace& building) {
  float height = 0;
  for (const glm::vec3& p : buildingModels()[static_cast<std::size_t>(building.building)][0].positions) {
    height = std::max(height, p.y);
  }
  return height * building.place.scale.y;
}

TEST_CASE("the models of buildings have unit normals, and stand on lots of 19 m above the ground") {
  for (const BuildingModel& model : buildingModels()) {
    std::uint64_t triangles = 0;
    for (const TriangleMesh& mesh : model) {
      triangles += mesh.triangleCount();
      REQUIRE(mesh.normals.size() == mesh.positions.size());
      for (const glm::vec3& normal : mesh.normals) REQUIRE(length(normal) == Approx(1));
      for (const glm::vec3& p : mesh.positions) {
        REQUIRE(std::abs(p.x) <= 9.5f);
        REQUIRE(std::abs(p.z) <= 9.5f);
        REQUIRE(p.y >= 0);
      }
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
                        &c = mesh.positions[mesh.indices[i + 2]];
        REQUIRE(dot(cross(b - a, c - a), mesh.normals[mesh.indices[i]]) > 0);
      }
    }
    CHECK(triangles > 1000);
    CHECK(triangles < 40'000);
  }
}

TEST_CASE("buildings of a city have lots of their own and are turned by multiples of 90 degrees") {
  const CityPlan plan = planCity(700);
  REQUIRE(plan.buildings.size() == 700);
  std::set<std::pair<double, double>> lots;
  std::set<Building> shown;
  for (const BuildingPlace& each : plan.buildings) {
    const glm::dvec3& at = each.place.translation;
    CHECK(lots.insert({at.x, at.z}).second);
    CHECK(std::abs(at.x) > 13 + 9.5);  // beside the avenue
    CHECK(at.y == CityPlan::kKerb);
    CHECK(std::abs(std::remainder(each.place.turn, std::numbers::pi / 2)) < 1e-12);
    CHECK(length(glm::dvec2(at.x, at.z)) < plan.radius);
    shown.insert(each.building);
  }
  CHECK(shown.size() == kBuildingCount);
}

TEST_CASE("the buildings at the centre of a city are three times as tall as those at its edge") {
  const CityPlan plan = planCity(1000);
  double centre = 0, edge = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    centre += heightOf(plan.buildings[i]) / 100;
    edge += heightOf(plan.buildings[900 + i]) / 100;
  }
  CHECK(centre > 3 * edge);
}

TEST_CASE("a smaller city is a part of a larger one") {
  const CityPlan small = planCity(50), large = planCity(2000);
  REQUIRE(large.buildings.size() == 2000);
  for (std::size_t i = 0; i < small.buildings.size(); ++i) {
    CHECK(small.buildings[i].place.translation == large.buildings[i].place.translation);
    CHECK(small.buildings[i].building == large.buildings[i].building);
  }
}

TEST_CASE("the meshes of a city are stored once, whatever its size") {
  const scene::LoadedScene small = generatedScene("city", 1000), large = generatedScene("city", 2000);
  CHECK(large.scene.meshes.size() == small.scene.meshes.size());
  CHECK(large.scene.placements.size() > small.scene.placements.size() + kBuildingPartCount * 1000);
  CHECK(large.scene.primitives.size() == kindNamed("city").primitiveCount(2000));
}

}  // namespace
}  // namespace candela::generate
