// The light trees of both tracers, which build them on their own, are the same to the last bit.
#include "host/trace/flatten/light_tree.h"

#include <bit>
#include <catch2/catch.hpp>

#include "host/trace/flatten/light_table.h"
#include "host/trace/reference/lights.h"
#include "tests/trace/light_tree_scenes.h"

using namespace candela;
using glm::vec3;
using test::LampNumbers;
using test::SceneBuilder;

namespace {

render::RenderSettings treeSettings(bool oneSided = false) {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.lights = render::LightSelection::tree;
  settings.image.oneSided = oneSided;
  return settings;
}

std::uint32_t bitsOf(float value) { return std::bit_cast<std::uint32_t>(value); }

bool isEqual(const flatten::LightNode& node, const reference::LightBounds& bounds) {
  const std::uint32_t flags = (bounds.byCosine ? gpu::kLightNodeCosine : 0) |
                              (bounds.isTwoSided ? gpu::kLightNodeTwoSided : 0);
  return node.centre == bounds.centre && bitsOf(node.radius) == bitsOf(bounds.radius) &&
         bitsOf(node.power) == bitsOf(bounds.power) && node.axis == (bounds.axis.word() | flags) &&
         bitsOf(node.cosine) == bitsOf(bounds.cosine);
}

// Compares two trees node by node, and returns the depth of the deepest leaf. `indexOf`: of what a leaf states as next
// in the tree of the reference.
template <class Index>
std::uint32_t requireEqualNodes(const flatten::LightTree& tree, const reference::LightTree& other,
                                const Index& indexOf) {
  REQUIRE(tree.leaves.size() == other.lights().size());
  REQUIRE(tree.inner.size() == other.inner().size());
  std::uint32_t deepest = 0;
  struct Pair {
    std::uint32_t node;
    bool isLeaf;
    reference::LightTree::Node other;
    std::uint32_t depth;
  };
  std::vector<Pair> pending{{0, tree.inner.empty(), other.root(), 0}};
  while (!pending.empty()) {
    const Pair pair = pending.back();
    pending.pop_back();
    REQUIRE(pair.isLeaf == pair.other.isLight);
    if (pair.isLeaf) {
      const flatten::LightNode& leaf = tree.leaves[pair.node];
      REQUIRE(indexOf(leaf.next) == pair.other.index);
      REQUIRE(isEqual(leaf, other.lights()[pair.other.index]));
      deepest = std::max(deepest, pair.depth);
      continue;
    }
    const flatten::LightNode& node = tree.inner[pair.node];
    const reference::LightTree::Inner& inner = other.inner()[pair.other.index];
    REQUIRE(isEqual(node, inner.bounds));
    const std::uint32_t middle = node.next & gpu::kLightNodeMask;
    pending.push_back({middle - 1, (node.next & gpu::kLightNodeLeftLeaf) != 0, inner.low, pair.depth + 1});
    pending.push_back({middle, (node.next & gpu::kLightNodeRightLeaf) != 0, inner.high, pair.depth + 1});
  }
  return deepest;
}

void requireEqualTrails(const std::vector<std::uint32_t>& trails, const reference::LightMesh& mesh) {
  for (std::uint32_t triangle = 0; triangle < trails.size(); ++triangle) {
    const auto index = mesh.indexInTree(triangle);
    REQUIRE(trails[triangle] == (index ? mesh.tree()->trail(*index) : gpu::kNoTrail));
  }
}

// Compares the trees of both tracers, and those of their meshes. Returns the depth of the deepest leaf.
std::uint32_t requireEqualTrees(const scene::Scene& scene, bool oneSided = false) {
  flatten::LightTable table = flatten::buildLightTable(scene, true, render::LightSelection::tree);
  REQUIRE(table.hasTree());
  const flatten::LightTree tree = buildLightTree(scene, table, oneSided);
  const reference::LightTable lights(scene, treeSettings(oneSided));
  REQUIRE(lights.tree());
  std::size_t leaves = 0;
  for (std::uint32_t i = 0; i < table.entries.size(); ++i) {
    const auto index = lights.indexInTree(i);
    REQUIRE(index.has_value() == table.entries[i].inTree);
    if (!index) continue;
    ++leaves;
    REQUIRE(table.entries[i].trail == lights.tree()->trail(*index));
  }
  CHECK(leaves == tree.leaves.size());
  REQUIRE(table.meshes.size() == lights.meshes().size());
  for (std::size_t i = 0; i < table.meshes.size(); ++i) {
    const reference::LightMesh& mesh = lights.meshes()[i];
    requireEqualNodes(table.meshes[i].tree, *mesh.tree(),
                      [&](std::uint32_t triangle) { return mesh.indexInTree(triangle); });
    requireEqualTrails(table.meshes[i].trails, mesh);
  }
  return requireEqualNodes(tree, *lights.tree(), [&](std::uint32_t entry) { return lights.indexInTree(entry); });
}

}  // namespace

TEST_CASE("both tracers build the same light tree of lights of all kinds") {
  const std::uint32_t count = GENERATE(2u, 5u, 40u, 3000u);
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    CAPTURE(count, seed);
    requireEqualTrees(test::mixedLamps(count, seed), seed % 2 == 1);
  }
}

TEST_CASE("both tracers build the same light trees of instances that emit and of their meshes") {
  const std::uint32_t instances = GENERATE(1u, 6u, 200u);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    CAPTURE(instances, seed);
    const scene::Scene scene = test::lampsAndInstances(seed % 3 == 0 ? 0 : 60, instances, seed);
    requireEqualTrees(scene, seed % 2 == 1);
    const flatten::LightTable table = flatten::buildLightTable(scene, true, render::LightSelection::tree);
    CHECK(table.meshes.size() <= 4);  // of two materials and both orientations
    CHECK(std::ranges::count_if(table.entries, &flatten::LightEntry::isInstance) == instances);
  }
}

TEST_CASE("both tracers build the same light tree where splits tie or do not exist") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1), vec3(2)));
  SECTION("a grid of equal spheres") {
    for (int i = 0; i < 512; ++i) b.sphere(vec3(i % 8, i / 8 % 8, i / 64), 0.125f);
  }
  SECTION("equal spheres in the same place") {
    for (int i = 0; i < 33; ++i) b.sphere(vec3(1, 2, 3), 0.5f);
  }
  SECTION("a line of triangles that face one another") {
    for (int i = 0; i < 64; ++i) {
      const float x = static_cast<float>(i), y = i % 2 == 0 ? 1.0f : -1.0f;
      b.triangle({x, 0, 0}, {x, y, 0}, {x, 0, 1});
    }
  }
  SECTION("one light") { b.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}); }
  requireEqualTrees(b.scene);
}

TEST_CASE("a light tree has at most 31 levels, even if each split cuts off one light") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1), vec3(2)));
  for (int i = 0; i < 300; ++i) b.sphere(vec3(std::exp2(static_cast<float>(i) / 4 - 30), 0, 0), 1e-12f);
  const std::uint32_t deepest = requireEqualTrees(b.scene);
  CHECK(deepest <= 31);
  CHECK(deepest > 20);
}

TEST_CASE("an environment, directional lights and point lights without fall-off stay beside a light tree") {
  scene::Scene scene = test::mixedLamps(62, 3);
  scene.pointLights = {{{0, 0, 5}, {1, 1, 1}}};
  flatten::LightTable table = flatten::buildLightTable(scene, true, render::LightSelection::tree);
  const reference::LightTable lights(scene, treeSettings());
  std::uint32_t previous = table.treeThreshold, outside = 0;
  CHECK(previous > 0);
  for (std::size_t i = 0; i < table.entries.size(); ++i) {
    const flatten::LightEntry& entry = table.entries[i];
    CHECK(entry.threshold == lights.thresholds()[i]);
    CHECK((entry.threshold - previous) * 0x1p-24 == double{entry.probability});
    if (entry.isPoint() || entry.kind == flatten::LightKind::directional)
      ++outside;
    else
      CHECK(entry.probability == 0);
    previous = entry.threshold;
  }
  CHECK(outside == 2);
  CHECK(previous == 1u << 24);
}
