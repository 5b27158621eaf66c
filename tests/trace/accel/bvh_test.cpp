// Invariants, quality and repeatability of BVHs.
#include "host/trace/accel/bvh.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <numeric>

#include "host/base/errors.h"
#include "tests/trace/accel/inputs.h"

using namespace candela;
using namespace candela::accel;
using namespace candela::test;

namespace {

// Returns the cost, by the same formula, of a BVH that is split at the median centre along the widest axis down to
// `leafSize`.
double medianCost(std::vector<Aabb> boxes, std::size_t leafSize, double rootArea) {
  Aabb bounds;
  for (const Aabb& b : boxes) bounds.extend(b);
  const double share = bounds.surfaceArea() / rootArea;
  if (boxes.size() <= leafSize) return share * static_cast<double>(boxes.size());
  const glm::dvec3 extent = bounds.extent();
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  std::sort(boxes.begin(), boxes.end(),
            [axis](const Aabb& a, const Aabb& b) { return a.min[axis] + a.max[axis] < b.min[axis] + b.max[axis]; });
  const auto middle = boxes.begin() + static_cast<std::ptrdiff_t>(boxes.size() / 2);
  return share + medianCost({boxes.begin(), middle}, leafSize, rootArea) +
         medianCost({middle, boxes.end()}, leafSize, rootArea);
}

Aabb unionOf(const std::vector<Aabb>& boxes) {
  return std::accumulate(boxes.begin(), boxes.end(), Aabb{},
                         [](Aabb all, const Aabb& b) { return all.extend(b), all; });
}

}  // namespace

TEST_CASE("every input gives a valid BVH for any rule, leaf size and depth limit") {
  for (const auto& [name, boxes] : builderInputs()) {
    for (const SplitRule rule : {SplitRule::binnedSah, SplitRule::coarseSah, SplitRule::midpoint}) {
      for (std::uint32_t leafSize : {1u, 2u, 4u, 8u}) {
        for (std::uint32_t depth : {60u, 16u}) {
          INFO(name << ", rule " << static_cast<int>(rule) << ", leaf size " << leafSize << ", depth " << depth);
          const BvhOptions options{.rule = rule, .maxLeafSize = leafSize, .maxDepth = depth};
          const Bvh bvh = buildBvh(boxes, options);
          const auto problem = validate(bvh, boxes, options);
          CHECK(problem.value_or("") == "");
          CHECK(bvh.nodes[0].bounds == unionOf(boxes));
        }
      }
    }
  }
}

TEST_CASE("a BVH without primitives has no nodes") {
  const Bvh bvh = buildBvh({});
  CHECK(bvh.nodes.empty());
  CHECK(bvh.primitiveIndices.empty());
  CHECK_FALSE(validate(bvh, {}).has_value());
  CHECK(quality(bvh).nodeCount == 0);
}

TEST_CASE("a BVH that only just fits stays within the depth limit") {
  // Each box is as far away as large: binning repeatedly splits off the largest few.
  std::vector<Aabb> boxes;
  for (int i = 0; i < 128; ++i)
    boxes.push_back(boxAround({std::exp2(i / 2.0), 0, 0}, glm::dvec3(std::exp2(i / 2.0) / 8)));
  const BvhOptions tight{.maxLeafSize = 1, .maxDepth = 7};
  const Bvh bvh = buildBvh(boxes, tight);
  CHECK(validate(bvh, boxes, tight).value_or("") == "");
  CHECK(quality(bvh).depth == 7);
  // Without the limit, the same boxes make a deeper BVH: the limit had an effect.
  CHECK(quality(buildBvh(boxes, {.maxLeafSize = 1})).depth > 7);
  CHECK_THROWS_AS(buildBvh(boxes, {.maxLeafSize = 1, .maxDepth = 6}), InternalError);
}

TEST_CASE("the BVH is the same for any number of threads") {
  const std::vector<Aabb> boxes = randomBoxes(100000);
  for (const SplitRule rule : {SplitRule::binnedSah, SplitRule::coarseSah, SplitRule::midpoint}) {
    const Bvh one = buildBvh(boxes, {.rule = rule, .threads = 1});
    for (std::uint32_t threads : {2u, 3u, 7u}) CHECK(buildBvh(boxes, {.rule = rule, .threads = threads}) == one);
    CHECK(quality(one).nodeCount > 50000);
  }
}

TEST_CASE("siblings are adjacent and subtrees contiguous, in depth-first order") {
  const Bvh bvh = buildBvh(randomBoxes(50000));
  std::vector<std::uint32_t> stack = {0};
  std::uint32_t next = 1;
  bool inOrder = true;
  while (!stack.empty()) {
    const BvhNode node = bvh.nodes[stack.back()];
    stack.pop_back();
    if (node.isLeaf()) continue;
    inOrder = inOrder && node.first == next;
    next += 2;
    stack.push_back(node.first + 1);
    stack.push_back(node.first);
  }
  CHECK(inOrder);
  CHECK(next == bvh.nodes.size());
}

TEST_CASE("SAH has a lower cost than the median split, especially if sizes and densities differ") {
  for (const auto& [name, boxes] : builderInputs()) {
    const double rootArea = unionOf(boxes).surfaceArea();
    if (rootArea == 0) continue;
    INFO(name);
    // Coincident boxes can only be split by their order; for other boxes, the loss must not exceed that of coarse
    // binning.
    CHECK(quality(buildBvh(boxes)).sahCost <= 1.01 * medianCost(boxes, 4, rootArea));
    if (name == "huge and tiny") CHECK(quality(buildBvh(boxes)).sahCost < 0.7 * medianCost(boxes, 4, rootArea));
  }
}

TEST_CASE("the costs of steps and tests decide between a leaf and a split") {
  const std::vector<Aabb> boxes = {boxAround({0, 0, 0}, glm::dvec3(1)), boxAround({10, 0, 0}, glm::dvec3(1))};
  // Root 12 x 2 x 2: half area 52; each half 12. Split: t 52 + i 24; leaf: i 104. So a leaf if t / i >= 80 / 52.
  CHECK(buildBvh(boxes, {.traversalCost = 1.5f}).nodes.size() == 3);
  CHECK(buildBvh(boxes, {.traversalCost = 1.6f}).nodes.size() == 1);
  CHECK(buildBvh(boxes, {.traversalCost = 1.6f, .intersectionCost = 1.1f}).nodes.size() == 3);
}

TEST_CASE("the quality of a BVH equals that computed by hand") {
  Bvh bvh;
  bvh.nodes = {{{{0, 0, 0}, {3, 1, 1}}, 1, 0}, {{{0, 0, 0}, {1, 1, 1}}, 0, 2}, {{{2, 0, 0}, {3, 1, 1}}, 2, 1}};
  bvh.primitiveIndices = {0, 1, 2};
  const BvhQuality q = quality(bvh, {.traversalCost = 2, .intersectionCost = 5});
  CHECK(q.sahCost == Approx(2 + (6.0 / 14) * 10 + (6.0 / 14) * 5));  // areas 14, 6, 6
  CHECK(q.depth == 1);
  CHECK(q.nodeCount == 3);
  CHECK(q.leafCount == 2);
  CHECK(q.averageLeafSize == 1.5);
  CHECK(q.maxLeafSize == 2);
}

TEST_CASE("boxes and options of a BVH that are out of range are refused, and the message states their values") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto refused = [](const Aabb& box) {
    CHECK_THROWS_WITH(buildBvh(std::vector{Aabb{{0, 0, 0}, {1, 1, 1}}, box}), Catch::StartsWith("BVH box 1 is ("));
  };
  refused({{0, nan, 0}, {1, 1, 1}});
  refused({{0, 0, 0}, {1, 1, nan}});
  refused(Aabb{});
  refused({{0, 0, 0}, {1, -1, 1}});
  refused({{0, 0, 0}, {1, 1, 2e30f}});
  const std::vector<Aabb> boxes = randomBoxes(10);
  CHECK_THROWS_AS(buildBvh(boxes, {.maxLeafSize = 0}), InternalError);
  CHECK_THROWS_AS(buildBvh(boxes, {.traversalCost = 0}), InternalError);
  CHECK_THROWS_AS(buildBvh(boxes, {.intersectionCost = nan}), InternalError);
}

TEST_CASE("validate reports the errors of a BVH") {
  const std::vector<Aabb> boxes = randomBoxes(40);
  const BvhOptions options{.maxLeafSize = 2, .maxDepth = 10, .traversalCost = 1000};
  const Bvh good = buildBvh(boxes, options);
  REQUIRE_FALSE(validate(good, boxes, options).has_value());
  const auto leaf = static_cast<std::size_t>(
      std::find_if(good.nodes.begin(), good.nodes.end(), [](const BvhNode& n) { return n.count == 2; }) -
      good.nodes.begin());
  REQUIRE(leaf < good.nodes.size());
  const auto complaint = [&](auto&& damage) {
    Bvh bad = good;
    damage(bad);
    return validate(bad, boxes, options).value_or("nothing");
  };
  using Catch::Contains;
  CHECK_THAT(complaint([](Bvh& b) { b.primitiveIndices.pop_back(); }), Contains("39 primitive indices for 40"));
  CHECK_THAT(complaint([](Bvh& b) { b.nodes.clear(); }), Contains("no nodes"));
  CHECK_THAT(complaint([](Bvh& b) { b.primitiveIndices[3] = b.primitiveIndices[4]; }), Contains("in two leaves"));
  CHECK_THAT(complaint([](Bvh& b) { b.primitiveIndices[3] = 40; }), Contains("names primitive 40"));
  CHECK_THAT(complaint([&](Bvh& b) { b.nodes[leaf].count = 1; }), Contains("is in no leaf"));
  CHECK_THAT(complaint([&](Bvh& b) { b.nodes[leaf].count = 3; }), Contains("the limit is 2"));
  CHECK_THAT(complaint([&](Bvh& b) { b.nodes[leaf].first = 39; }), Contains("of 40"));
  CHECK_THAT(complaint([&](Bvh& b) { b.nodes[leaf].bounds.max.x = b.nodes[leaf].bounds.min.x; }),
             Contains("reaches out of leaf"));
  CHECK_THAT(complaint([](Bvh& b) { b.nodes[1].bounds.max.x += 1000; }), Contains("reaches out of its parent 0"));
  CHECK_THAT(complaint([](Bvh& b) { b.nodes[0].first = 0; }), Contains("has its children at 0"));
  CHECK_THAT(complaint([](Bvh& b) { b.nodes[0].first = ~0u; }), Contains("has its children at"));
  CHECK_THAT(complaint([](Bvh& b) { b.nodes.emplace_back(); }), Contains("nodes are reached"));
  CHECK_THAT(validate(good, boxes, {.maxLeafSize = 2, .maxDepth = 3}).value_or(""), Contains("the limit is 3"));
  CHECK_THAT(validate(good, {}, options).value_or(""), Contains("40 primitive indices for 0"));
}
