// The midpoint split, on few enough boxes that the results can be checked by hand.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "host/trace/accel/bvh.h"
#include "tests/trace/accel/inputs.h"

using namespace candela;
using namespace candela::accel;
using namespace candela::test;

namespace {

constexpr BvhOptions kReport{.rule = SplitRule::midpoint, .maxLeafSize = 2};

using Members = std::set<std::uint32_t>;

Members membersOf(const Bvh& bvh, std::uint32_t node) {
  const BvhNode& n = bvh.nodes[node];
  if (n.isLeaf()) {
    const auto first = bvh.primitiveIndices.begin() + n.first;
    return {first, first + n.count};
  }
  Members members = membersOf(bvh, n.first);
  members.merge(membersOf(bvh, n.first + 1));
  return members;
}

// Points along an axis.
std::vector<Aabb> pointsAt(const std::vector<double>& places, int axis = 0) {
  std::vector<Aabb> boxes;
  for (const double place : places) {
    glm::dvec3 point(0);
    point[axis] = place;
    boxes.push_back(boxAround(point, glm::dvec3(0)));
  }
  return boxes;
}

Members leftOfRoot(const std::vector<Aabb>& boxes) { return membersOf(buildBvh(boxes, kReport), 1); }

}  // namespace

TEST_CASE("a node is split at the centre of the longest axis of its box") {
  CHECK(leftOfRoot(pointsAt({0, 10, 4.9, 5.1})) == Members{0, 2});
  CHECK(leftOfRoot(pointsAt({0, 10, 4.9, 5.1}, 2)) == Members{0, 2});
  // The box is longer along y, though the centres are farther apart along x.
  const std::vector<Aabb> boxes{boxAround({0, 0, 0}, {0, 9, 0}), boxAround({8, -1, 0}, {0, 9, 0}),
                                boxAround({4, 1, 0}, {0, 9, 0})};
  CHECK(leftOfRoot(boxes) == Members{1});
}

TEST_CASE("a node whose centres are on one side is split at their mean") {
  // The last box fills the node, so that no centre is left of 5; their mean is (10 + 9 + 6 + 5) / 4 = 7.5.
  std::vector<Aabb> boxes = pointsAt({10, 9, 6});
  boxes.push_back({{0, 0, 0}, {10, 0, 0}});
  CHECK(leftOfRoot(boxes) == Members{2, 3});
}

TEST_CASE("if all centres coincide, two primitives go to the left and the rest to the right") {
  const std::vector<Aabb> boxes(7, boxAround({1, 2, 3}, {1, 1, 1}));
  const Bvh bvh = buildBvh(boxes, kReport);
  REQUIRE_FALSE(validate(bvh, boxes, kReport).has_value());
  std::uint32_t node = 0;
  for (const std::size_t rest : {5u, 3u, 1u}) {
    const std::uint32_t left = bvh.nodes[node].first;
    CHECK(membersOf(bvh, left).size() == 2);
    CHECK(membersOf(bvh, left + 1).size() == rest);
    node = left + 1;
  }
}

TEST_CASE("median splits limit the depth if midpoint splits would exceed it") {
  const std::vector<Aabb> boxes(10000, boxAround({1, 2, 3}, {1, 1, 1}));
  const Bvh bvh = buildBvh(boxes, kReport);
  CHECK(validate(bvh, boxes, kReport).value_or("") == "");
  CHECK(quality(bvh).depth == kReport.maxDepth);
}

TEST_CASE("two primitives become one leaf, three do not") {
  CHECK(buildBvh(pointsAt({0, 1}), kReport).nodes.size() == 1);
  const BvhQuality q = quality(buildBvh(pointsAt({0, 1, 2}), kReport));
  CHECK(q.leafCount == 2);
  CHECK(q.maxLeafSize == 2);
}

TEST_CASE("SAH has a lower cost than the midpoint split if sizes and densities differ") {
  for (const auto& [name, boxes] : builderInputs()) {
    if (name != "huge and tiny" && name != "clustered") continue;
    INFO(name);
    CHECK(quality(buildBvh(boxes, {.maxLeafSize = 2})).sahCost < quality(buildBvh(boxes, kReport)).sahCost);
  }
}
