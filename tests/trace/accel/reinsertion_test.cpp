// Reinsertion: BVHs stay valid and never cost more, whatever the boxes, the depth limit and the threads.
#include "host/trace/accel/reinsertion.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "host/trace/accel/linked_tree.h"
#include "tests/trace/accel/inputs.h"

using namespace candela;
using namespace candela::accel;
using namespace candela::test;

namespace {

constexpr std::size_t kEverything = ~std::size_t{0};

BvhOptions reinserting(Reinsertion reinsertion, std::uint32_t maxDepth = 60) {
  return {.reinsertion = reinsertion, .maxDepth = maxDepth};
}

double costOf(const Bvh& bvh) { return quality(bvh).sahCost; }

// Small boxes all over a room, whose walls are two large flat boxes each, like those of triangles.
std::vector<Aabb> furnishedRoom(std::size_t count) {
  std::vector<Aabb> boxes = randomBoxes(count);
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-20.0f, 120.0f}) {
      Aabb wall{glm::vec3(-20), glm::vec3(120)};
      wall.min[axis] = wall.max[axis] = side;
      boxes.insert(boxes.end(), 2, wall);
    }
  }
  return boxes;
}

// Returns the maximum gain over all possible moves.
double largestGain(const LinkedTree& tree) {
  double largest = 0;
  const auto count = static_cast<std::uint32_t>(tree.nodes().size());
  for (std::uint32_t from = 1; from < count; ++from) {
    for (std::uint32_t to = 0; to < count; ++to) {
      const SubtreeMove move{from, to};
      if (to == tree.parentOf(from) || to == LinkedTree::siblingOf(from) || !tree.mayMove(move, 60)) continue;
      LinkedTree moved = tree;
      moved.move(move);
      largest = std::max(largest, tree.innerHalfArea() - moved.innerHalfArea());
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("reinsertion keeps every BVH valid, within the depth limit, and never increases its cost") {
  for (const auto& [name, boxes] : builderInputs()) {
    for (const std::uint32_t depth : {60u, 16u}) {
      INFO(name << ", depth " << depth);
      const double before = costOf(buildBvh(boxes, reinserting(Reinsertion::none, depth)));
      double last = before;
      for (const Reinsertion reinsertion : {Reinsertion::trunk, Reinsertion::all}) {
        const BvhOptions options = reinserting(reinsertion, depth);
        const Bvh bvh = buildBvh(boxes, options);
        CHECK(validate(bvh, boxes, options).value_or("") == "");
        CHECK(costOf(bvh) <= (1 + 1e-12) * last);
        last = costOf(bvh);
      }
    }
  }
}

TEST_CASE(
    "reinsertion of all nodes improves a BVH of random boxes, and that of the trunk separates the walls of a room") {
  const std::vector<Aabb> scattered = randomBoxes(20000);
  CHECK(costOf(buildBvh(scattered, reinserting(Reinsertion::all))) < 0.98 * costOf(buildBvh(scattered)));
  const std::vector<Aabb> room = furnishedRoom(5000);
  CHECK(costOf(buildBvh(room, reinserting(Reinsertion::trunk))) < 0.95 * costOf(buildBvh(room)));
}

TEST_CASE("after reinsertion of all nodes, no single move would gain much more") {
  const std::vector<Aabb> boxes = furnishedRoom(60);
  const LinkedTree before(buildBvh(boxes, {.maxLeafSize = 1}), kEverything);
  const LinkedTree after(buildBvh(boxes, {.reinsertion = Reinsertion::all, .maxLeafSize = 1}), kEverything);
  CHECK(largestGain(before) > 0.005 * before.innerHalfArea());
  CHECK(largestGain(after) < 0.001 * after.innerHalfArea());
}

TEST_CASE("reinsertion never exceeds a depth limit that the BVH has reached") {
  const std::vector<Aabb> boxes = randomBoxes(128);
  const BvhOptions tight{.reinsertion = Reinsertion::all, .maxLeafSize = 1, .maxDepth = 7};
  CHECK(validate(buildBvh(boxes, tight), boxes, tight).value_or("") == "");
  // Without the limit, the same boxes make a deeper BVH: the limit had an effect.
  CHECK(quality(buildBvh(boxes, {.reinsertion = Reinsertion::all, .maxLeafSize = 1})).depth > 7);
}

TEST_CASE("reinsertion gives the same BVH for any number of threads") {
  const std::vector<Aabb> boxes = randomBoxes(30000);
  for (const Reinsertion reinsertion : {Reinsertion::trunk, Reinsertion::all}) {
    BvhOptions options = reinserting(reinsertion);
    options.threads = 1;
    const Bvh one = buildBvh(boxes, options);
    for (const std::uint32_t threads : {2u, 3u, 7u}) {
      options.threads = threads;
      CHECK(buildBvh(boxes, options) == one);
    }
  }
  // The comparison could not fail if nothing had moved.
  CHECK_FALSE(buildBvh(boxes, reinserting(Reinsertion::all)) == buildBvh(boxes));
}

TEST_CASE("a trunk of any size reproduces the whole BVH") {
  const std::vector<Aabb> boxes = randomBoxes(3000);
  const Bvh bvh = buildBvh(boxes);
  for (const std::size_t limit : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{100}, kEverything}) {
    const LinkedTree tree(bvh, limit);
    CHECK(tree.nodes().size() <= limit);
    CHECK(tree.layOut(bvh) == bvh);
  }
}

TEST_CASE("a subtree can move next to its grandparent or to distant nodes, but never into itself") {
  // Leaves at 0, 1, 10 and 11 on a line, joined in this order two by two.
  std::vector<Aabb> boxes;
  for (const double x : {0.0, 1.0, 10.0, 11.0}) boxes.push_back(boxAround({x, 0, 0}, glm::dvec3(0.25)));
  const BvhOptions options{.maxLeafSize = 1};
  const Bvh bvh = buildBvh(boxes, options);
  const LinkedTree tree(bvh, kEverything);
  const std::uint32_t left = bvh.nodes[0].first, leaf = bvh.nodes[left].first;
  CHECK_FALSE(tree.mayMove({left, leaf}, 60));
  CHECK_FALSE(tree.mayMove({leaf, left + 1}, 2));
  for (const std::uint32_t to : {0u, left + 1, bvh.nodes[left + 1].first}) {
    const SubtreeMove move{leaf, to};
    REQUIRE(tree.mayMove(move, 60));
    LinkedTree moved = tree;
    moved.move(move);
    const Bvh result = moved.layOut(bvh);
    CHECK(validate(result, boxes, options).value_or("") == "");
    CHECK_FALSE(result == bvh);
  }
}
