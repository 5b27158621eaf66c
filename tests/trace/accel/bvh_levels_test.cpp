// Levels of simple BVHs, and of all inputs with which builders are tested.
#include "host/trace/accel/bvh_levels.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/trace/accel/inputs.h"

using namespace candela;
using namespace candela::accel;
using namespace candela::test;

TEST_CASE("without a level all boxes are returned, each after the box that contains it") {
  for (const auto& [name, inputs] : builderInputs()) {
    INFO(name);
    const Bvh bvh = buildBvh(inputs);
    const std::vector<LevelBox> boxes = levelBoxes(bvh, std::nullopt);
    REQUIRE(boxes.size() == bvh.nodes.size());
    CHECK(boxes.front().depth == 0);
    const auto deeper = [](const LevelBox& a, const LevelBox& b) { return a.depth < b.depth; };
    CHECK(std::ranges::max_element(boxes, deeper)->depth == quality(bvh).depth);
  }
}

TEST_CASE("every level contains every primitive of the scene once") {
  const std::vector<Aabb> inputs = randomBoxes(200);
  const Bvh bvh = buildBvh(inputs);
  for (std::uint32_t level = 0; level <= quality(bvh).depth; ++level) {
    const std::vector<LevelBox> boxes = levelBoxes(bvh, level);
    for (const Aabb& input : inputs) {
      CHECK(std::ranges::any_of(boxes, [&](const LevelBox& box) { return box.bounds.contains(input); }));
    }
  }
}

TEST_CASE("a level contains its nodes and the leaves above it") {
  // Distances 1, 2, 4, ...: every midpoint split separates the farthest point, so that each level has one leaf.
  std::vector<Aabb> inputs;
  for (int i = 0; i < 6; ++i) inputs.push_back(boxAround({std::exp2(2 * i), 0, 0}, glm::dvec3(0)));
  const Bvh bvh = buildBvh(inputs, {.rule = SplitRule::midpoint, .maxLeafSize = 1});
  REQUIRE(quality(bvh).depth == 5);
  for (std::uint32_t level = 0; level <= 5; ++level) {
    const std::vector<LevelBox> boxes = levelBoxes(bvh, level);
    INFO("level " << level);
    CHECK(boxes.size() == level + 1);
    const auto own = std::ranges::count_if(boxes, [&](const LevelBox& box) { return box.depth == level; });
    CHECK(own == (level == 0 ? 1 : 2));
  }
  CHECK(levelBoxes(bvh, 60).size() == 6);
}

TEST_CASE("an empty BVH has no boxes") { CHECK(levelBoxes({}, std::nullopt).empty()); }
