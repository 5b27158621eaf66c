// The choice of the children of 8-wide nodes, compared with every other choice.
#include "host/trace/accel/wide_families.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "tests/trace/accel/inputs.h"

using namespace candela;
using namespace candela::accel;
using namespace candela::test;

namespace {

double chanceOf(const Bvh& bvh, std::uint32_t node) {
  return bvh.nodes[node].bounds.surfaceArea() / bvh.nodes[0].bounds.surfaceArea();
}

// Returns the chosen 8-wide nodes at and below `node`, each weighted by its hit probability.
double chosenCost(const Bvh& bvh, const WideFamilies& families, std::uint32_t node) {
  if (bvh.nodes[node].isLeaf()) return 0;
  const Family family = families.of(node);
  double cost = chanceOf(bvh, node);
  for (std::uint32_t i = 0; i < family.size; ++i) cost += chosenCost(bvh, families, family.members[i]);
  return cost;
}

double minCost(const Bvh& bvh, std::uint32_t node);

// Tries all families whose first `fixedCount` members are decided.
double minCostOfFamilies(const Bvh& bvh, std::vector<std::uint32_t> members, std::size_t fixedCount) {
  if (members.size() > kWideChildren) return std::numeric_limits<double>::infinity();
  if (fixedCount == members.size()) {
    double cost = 0;
    for (const std::uint32_t member : members) cost += minCost(bvh, member);
    return cost;
  }
  double least = minCostOfFamilies(bvh, members, fixedCount + 1);
  const BvhNode& open = bvh.nodes[members[fixedCount]];
  if (open.isLeaf()) return least;
  members[fixedCount] = open.first;
  members.push_back(open.first + 1);
  return std::min(least, minCostOfFamilies(bvh, std::move(members), fixedCount));
}

double minCost(const Bvh& bvh, std::uint32_t node) {
  const BvhNode& inner = bvh.nodes[node];
  if (inner.isLeaf()) return 0;
  return chanceOf(bvh, node) + minCostOfFamilies(bvh, {inner.first, inner.first + 1}, 0);
}

}  // namespace

TEST_CASE("no other choice of children has a smaller expected number of visited 8-wide nodes") {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const Bvh bvh = buildBvh(randomBoxes(13, seed), {.maxLeafSize = 1});
    CHECK(chosenCost(bvh, WideFamilies(bvh), 0) == Approx(minCost(bvh, 0)).epsilon(1e-5));
  }
}

TEST_CASE("a family has two to eight members that contain all leaves below its node") {
  const Bvh bvh = buildBvh(randomBoxes(5000), {.maxLeafSize = 3});
  const WideFamilies families(bvh);
  std::vector<std::uint32_t> stack{0};
  std::size_t leaves = 0;
  while (!stack.empty()) {
    const Family family = families.of(stack.back());
    stack.pop_back();
    REQUIRE(family.size >= 2);
    REQUIRE(family.size <= kWideChildren);
    for (std::uint32_t i = 0; i < family.size; ++i) {
      const std::uint32_t member = family.members[i];
      if (!bvh.nodes[member].isLeaf()) stack.push_back(member);
      leaves += bvh.nodes[member].isLeaf();
    }
  }
  CHECK(leaves == quality(bvh).leafCount);
}

TEST_CASE("boxes without any area still fill 8-wide nodes") {
  const std::vector<Aabb> points(512, boxAround(glm::dvec3(5), glm::dvec3(0)));
  const Bvh bvh = buildBvh(points, {.maxLeafSize = 1});
  CHECK(WideFamilies(bvh).of(0).size == kWideChildren);
}
