// Invariants of 8-wide BVHs and of their quantised boxes.
#include "host/trace/accel/wide_bvh.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/trace/accel/inputs.h"
#include "tests/trace/accel/wide_ray.h"

using namespace candela;
using namespace candela::accel;
using namespace candela::test;

namespace {

constexpr std::uint32_t kDepth = 60;

WideBvh wideOver(std::span<const Aabb> boxes, SplitRule rule = SplitRule::binnedSah) {
  return collapse(buildBvh(boxes, {.rule = rule, .maxLeafSize = kMaxWideLeaf, .maxDepth = kDepth}));
}

double largestOf(const glm::vec3& v) { return std::max({v.x, v.y, v.z}); }

double centre(const QuantisedBoxes& boxes, int axis, std::uint32_t child) {
  return boxes.plane(axis, boxes.low[axis][child]) + boxes.plane(axis, boxes.high[axis][child]);
}

}  // namespace

TEST_CASE("every input gives a valid 8-wide BVH for any rule") {
  for (const auto& [name, boxes] : builderInputs()) {
    for (const SplitRule rule : {SplitRule::binnedSah, SplitRule::coarseSah, SplitRule::midpoint}) {
      INFO(name << ", rule " << static_cast<int>(rule));
      CHECK(validate(wideOver(boxes, rule), boxes, kDepth).value_or("") == "");
    }
  }
}

TEST_CASE("an 8-wide BVH without primitives has no nodes") {
  CHECK(collapse(Bvh{}).nodes.empty());
  CHECK_FALSE(validate(WideBvh{}, {}, kDepth).has_value());
}

TEST_CASE("an 8-wide BVH has at most a third of the nodes and half of the depth, and few gaps") {
  const std::vector<Aabb> boxes = randomBoxes(20000);
  const Bvh bvh = buildBvh(boxes, {.maxLeafSize = kMaxWideLeaf});
  const WideBvh wide = collapse(bvh);
  const std::size_t inner = (bvh.nodes.size() - 1) / 2;
  CHECK(wide.nodeCount < inner / 3);
  CHECK(wide.depth <= quality(bvh).depth / 2);
  CHECK(10 * wide.nodes.size() < 11 * wide.nodeCount);
}

TEST_CASE("most pairs of children whose indices differ in one bit lie on the sides that the bit states") {
  const WideBvh wide = wideOver(randomBoxes(20000));
  int right = 0, all = 0;
  for (const WideNode& node : wide.nodes) {
    if (node.innerMask != 0xff) continue;
    for (int axis = 0; axis < 3; ++axis) {
      for (std::uint32_t child = 0; child < kWideChildren; ++child) {
        if ((child >> axis & 1) != 0) continue;
        ++all;
        right += centre(node.boxes, axis, child) <= centre(node.boxes, axis, child | 1u << axis);
      }
    }
  }
  CHECK(all > 1000);
  CHECK(right > 0.75 * all);
}

TEST_CASE("quantised boxes exceed the boxes by at least the margin, and by little more than a step of the grid") {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const double away = std::exp2(random.real(-20, 20)), size = std::exp2(random.real(-30, 10));
    std::vector<Aabb> boxes;
    Aabb all;
    for (int k = 0; k < 8; ++k) {
      boxes.push_back(boxAround(glm::dvec3(away) + random.inCube(-size, size), size * random.inCube(0, 0.5)));
      all.extend(boxes.back());
    }
    const QuantisedBoxes grid = quantise(boxes);
    for (int axis = 0; axis < 3; ++axis) {
      const double margin = kPlaneMargin * std::max(std::abs(double{all.min[axis]}), std::abs(double{all.max[axis]}));
      const double loss = margin + 2.1 * (all.extent()[axis] + 2.1 * margin) / 255;
      for (std::uint32_t child = 0; child < 8; ++child) {
        const double below = boxes[child].min[axis] - grid.plane(axis, grid.low[axis][child]);
        const double above = grid.plane(axis, grid.high[axis][child]) - boxes[child].max[axis];
        REQUIRE(std::min(below, above) >= 0.99 * margin);
        REQUIRE(std::max(below, above) <= loss);
      }
    }
  }
}

// A primitive test may report a hit so far from its primitive, to any side: also before it.
TEST_CASE("a ray with a hit at the error bound of a primitive test intersects the quantised box") {
  constexpr double kPrimitiveError = 20 * 0x1p-24;
  Random random(4);
  for (int i = 0; i < 300000; ++i) {
    const double away = std::exp2(random.real(-10, 10)), size = std::exp2(random.real(-20, 5));
    std::vector<Aabb> exact, padded;
    for (int k = 0; k < 8; ++k) {
      exact.push_back(
          boxAround(away * random.inCube(-1, 1) + random.inCube(-size, size), size * random.inCube(0, 0.2)));
      const double pad = double{kBoundsPad} * largestOf(glm::max(glm::abs(exact[k].min), glm::abs(exact[k].max)));
      padded.push_back({glm::vec3(glm::dvec3(exact[k].min) - pad), glm::vec3(glm::dvec3(exact[k].max) + pad)});
    }
    const auto child = static_cast<std::uint32_t>(i % 8);
    const glm::bvec3 upper(random.real() < 0.5, random.real() < 0.5, random.real() < 0.5);
    const glm::dvec3 corner = glm::mix(exact[child].min, exact[child].max, upper);
    const glm::vec3 origin(std::exp2(random.real(-10, 12)) * random.direction());
    const double error = kPrimitiveError * (largestOf(glm::abs(glm::vec3(corner))) + largestOf(glm::abs(origin)));
    const glm::dvec3 path = corner + error * random.inCube(-1, 1) - glm::dvec3(origin);
    const Ray<float> ray{origin, glm::vec3(glm::normalize(path))};
    REQUIRE(WideRay<float>(ray).meets(quantise(padded), child, static_cast<float>(glm::length(path))));
  }
}

TEST_CASE("a leaf too large for an 8-wide node is refused") {
  const std::vector<Aabb> boxes = randomBoxes(100);
  CHECK_THROWS_AS(collapse(buildBvh(boxes, {.maxLeafSize = 8, .traversalCost = 1000})), InternalError);
}

TEST_CASE("validate reports the errors of an 8-wide BVH") {
  const std::vector<Aabb> boxes = randomBoxes(400);
  const WideBvh good = collapse(buildBvh(boxes, {.maxLeafSize = kMaxWideLeaf, .traversalCost = 4}));
  REQUIRE_FALSE(validate(good, boxes, kDepth).has_value());
  const auto leafy = static_cast<std::size_t>(
      std::find_if(good.nodes.begin(), good.nodes.end(), [](const WideNode& n) { return (n.leafMask & 3) == 3; }) -
      good.nodes.begin());
  REQUIRE(leafy < good.nodes.size());
  const auto complaint = [&](auto&& damage) {
    WideBvh bad = good;
    damage(bad);
    return validate(bad, boxes, kDepth).value_or("nothing");
  };
  using Catch::Contains;
  CHECK_THAT(complaint([](WideBvh& w) { w.primitiveIndices.pop_back(); }), Contains("399 primitive indices for 400"));
  CHECK_THAT(complaint([](WideBvh& w) { w.nodes.pop_back(); }), Contains("names node"));
  CHECK_THAT(complaint([](WideBvh& w) { w.nodes.clear(); }), Contains("0 nodes for 400"));
  CHECK_THAT(complaint([](WideBvh& w) { w.nodes[0].block = 0; }), Contains("is named twice"));
  CHECK_THAT(complaint([](WideBvh& w) { w.nodes[0].block = 1u << 20; }), Contains("names node 10485"));
  CHECK_THAT(complaint([](WideBvh& w) { w.nodes[0].leafMask = 0xffffff; }), Contains("both node and leaf"));
  CHECK_THAT(complaint([](WideBvh& w) { w.nodeCount += 1; }), Contains("but nodeCount is"));
  CHECK_THAT(complaint([&](WideBvh& w) { w.nodes[leafy].leafMask ^= 1; }), Contains("has gaps"));
  CHECK_THAT(complaint([&](WideBvh& w) { w.nodes[leafy].leafMask |= 1u << 24; }), Contains("beyond its children"));
  CHECK_THAT(complaint([&](WideBvh& w) { w.nodes[leafy].firstPrimitive = 400; }), Contains("of 400"));
  CHECK_THAT(complaint([](WideBvh& w) { w.primitiveIndices[3] = w.primitiveIndices[4]; }), Contains("in two leaves"));
  CHECK_THAT(complaint([](WideBvh& w) { w.primitiveIndices[3] = 400; }), Contains("names primitive 400"));
  CHECK_THAT(complaint([&](WideBvh& w) { w.nodes[leafy].boxes.high[1][0] = w.nodes[leafy].boxes.low[1][0]; }),
             Contains("reaches out of its quantised box"));
  CHECK_THAT(complaint([](WideBvh& w) {
               ++w.nodes[0].boxes.low[2][0];
               w.nodes[0].boxes.low[2][0] += 20;
             }),
             Contains("reaches out of its quantised box"));
  CHECK_THAT(validate(good, boxes, 1).value_or(""), Contains("the limit is 1"));
}
