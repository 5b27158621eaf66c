// The forest: trees stand on the ground, apart from each other and off the lake; every model is stored once.
#include "host/scene/generate/forest.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "tests/scene/generate/generated_text.h"

namespace candela::generate {
namespace {

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void checkMesh(const TriangleMesh& mesh) {
  REQUIRE(mesh.normals.size() == mesh.positions.size());
  for (const glm::vec3& position : mesh.positions) REQUIRE(isFinite(position));
  for (const glm::vec3& normal : mesh.normals) REQUIRE(length(normal) == Approx(1));
  for (const std::uint32_t index : mesh.indices) REQUIRE(index < mesh.positions.size());
}

TEST_CASE("the models of trees have thousands of triangles with unit normals, and feet below the ground") {
  for (const Plant& plant : speciesModels()) {
    checkMesh(plant.bark);
    checkMesh(plant.leaves);
    CHECK(plant.bark.triangleCount() + plant.leaves.triangleCount() > 5000);
    CHECK(plant.bark.triangleCount() + plant.leaves.triangleCount() < 20'000);
    float lowest = 0;
    for (const glm::vec3& position : plant.bark.positions) lowest = std::min(lowest, position.y);
    CHECK(lowest < -0.5f);
  }
}

TEST_CASE("trees stand on the ground beside the lake, 0.7 to 1.4 times as large as their models, and apart") {
  const LakeValley valley;
  const std::vector<Tree> trees = plantTrees(valley, 1500);
  REQUIRE(trees.size() == 1500);
  std::set<std::pair<Species, std::size_t>> shown;
  for (const Tree& tree : trees) {
    const glm::dvec3& at = tree.place.translation;
    CHECK(LakeValley::shoreDistance({at.x, at.z}) > 0);
    CHECK(at.y > 0);
    CHECK(at.y == Approx(valley.heightAt({at.x, at.z})));
    for (int axis = 0; axis < 3; ++axis) CHECK((tree.place.scale[axis] >= 0.7 && tree.place.scale[axis] <= 1.4));
    for (const Tree& other : trees) {
      if (&other != &tree) REQUIRE(length(other.place.translation - at) > 2.7);
    }
    shown.insert({tree.species, tree.tint});
  }
  CHECK(shown.size() == kSpeciesCount * kTintCount);
}

TEST_CASE("a smaller forest is a part of a larger one") {
  const LakeValley valley;
  const std::vector<Tree> small = plantTrees(valley, 100), large = plantTrees(valley, 3000);
  REQUIRE(large.size() == 3000);
  for (std::size_t i = 0; i < small.size(); ++i) {
    CHECK(small[i].place.translation == large[i].place.translation);
    CHECK(small[i].species == large[i].species);
  }
}

TEST_CASE("the height of the ground is that of its mesh") {
  const LakeValley valley;
  const TriangleMesh ground = valley.groundMesh();
  checkMesh(ground);
  checkMesh(LakeValley::waterMesh());
  for (std::size_t i = 0; i < ground.indices.size(); i += 999) {
    glm::dvec3 middle(0);
    for (std::size_t k = 0; k < 3; ++k) middle += glm::dvec3(ground.positions[ground.indices[i + k]]) / 3.0;
    CHECK(valley.heightAt({middle.x, middle.z}) == Approx(middle.y).margin(1e-3));
  }
}

TEST_CASE("the meshes of a forest are stored once, whatever its size") {
  const scene::LoadedScene small = generatedScene("forest", 300), large = generatedScene("forest", 1200);
  CHECK(large.scene.meshes.size() == small.scene.meshes.size());
  CHECK(large.scene.placements.size() == small.scene.placements.size() + 2 * std::size_t{900});
  CHECK(large.scene.primitives.size() == kindNamed("forest").primitiveCount(1200));
}

}  // namespace
}  // namespace candela::generate
