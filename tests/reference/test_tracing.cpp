// Closest hits and occlusion: the hierarchy against brute force, ties, sides.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "host/reference/tracing.h"
#include "tests/reference/scene_builder.h"

using namespace candela;
using namespace candela::reference;
using glm::vec3;
using test::SceneBuilder;

namespace {

RenderSettings withAccel(AccelKind accel, bool oneSided = false) {
  RenderSettings settings;
  settings.accel = accel;
  settings.oneSided = oneSided;
  return settings;
}

class RandomScene {
 public:
  Scene make(int perKind) {
    b_.material(test::diffuseMaterial(vec3(0.5f)));
    for (int i = 0; i < perKind; ++i) {
      const vec3 p = 10.0f * point();
      b_.sphere(p, 0.5f * uniform());
      b_.triangle(p, p + point(), p + point());
      b_.triangle(p, p, p);  // without area
      const vec3 q = 10.0f * point();
      b_.box(q, q + glm::abs(point()) * vec3(1, 1, i % 2 == 0 ? 0 : 1));
      b_.cone(p, std::abs(uniform()), p + point(), std::abs(uniform()));
      if (i % 20 == 0) b_.sphere(p, 0.3f).sphere(p, 0.3f);                          // equal spheres tie
      if (i % 20 == 1) b_.box(q, q + vec3(1)).box(q - vec3(1, 1, 0), q + vec3(1));  // faces in one plane tie
    }
    b_.plane({0, -12, 0}, {0, -12, 1}, {1, -12, 0}).plane({0, -12, 0}, {0, -12, 1}, {1, -12, 0});
    return b_.scene;
  }
  float uniform() { return uniform_(random_); }
  vec3 point() { return {uniform(), uniform(), uniform()}; }

 private:
  SceneBuilder b_;
  std::mt19937 random_{17};
  std::uniform_real_distribution<float> uniform_{-1, 1};
};

}  // namespace

TEST_CASE("the hierarchy finds what brute force finds, in scenes of all kinds and with ties") {
  RandomScene random;
  const Scene scene = random.make(100);
  const Tracing brute(scene, withAccel(AccelKind::none));
  const Tracing tree(scene, withAccel(AccelKind::bvh));
  REQUIRE(tree.hasHierarchy());
  REQUIRE_FALSE(brute.hasHierarchy());

  Counters bruteWork, treeWork;
  int hits = 0, ties = 0, occlusions = 0;
  for (int i = 0; i < 8000; ++i) {
    Ray ray{dvec3(12.0f * random.point()), normalize(dvec3(random.point()))};
    if (i % 10 == 0) ray.direction = dvec3(0, i % 20 == 0 ? 1 : -1, 0);
    if (i % 3 == 0) {  // from a surface
      const Hit start = brute.closest(ray, bruteWork);
      if (start) ray = {ray.at(start.distance), normalize(dvec3(random.point())), start.primitive, -ray.direction};
    }
    const Hit expected = brute.closest(ray, bruteWork);
    const Hit found = tree.closest(ray, treeWork);
    REQUIRE(found.primitive == expected.primitive);
    REQUIRE(found.distance == expected.distance);
    hits += expected.primitive != kNoPrimitive;
    if (expected) {
      // The winner of a tie is the lower index: hiding it, the other one is as near.
      ties += brute.isOccluded(ray, std::nextafter(expected.distance, kNoHit), expected.primitive, bruteWork);
    }
    for (const double distance : {0.5, 5.0, 50.0}) {
      const bool occluded = brute.isOccluded(ray, distance, 7, bruteWork);
      REQUIRE(tree.isOccluded(ray, distance, 7, treeWork) == occluded);
      occlusions += occluded;
    }
  }
  CHECK(hits > 3000);
  CHECK(ties > 100);
  CHECK(occlusions > 1000);
  CHECK(treeWork.traversalSteps * 3 < bruteWork.traversalSteps);
}

TEST_CASE("every primitive is in exactly one leaf, within the leaf's box") {
  RandomScene random;
  const Scene scene = random.make(60);
  std::vector<Bounds> boxes;
  for (const Primitive& primitive : scene.primitives) {
    if (const auto bounds = boundsOf(scene, primitive)) boxes.push_back(*bounds);
  }
  const Hierarchy hierarchy = buildHierarchy(boxes);
  std::vector<int> seen(boxes.size());
  for (const Node& node : hierarchy.nodes) {
    CHECK(node.count <= Hierarchy::kLeafSize);
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t item = hierarchy.order[i];
      ++seen[item];
      CHECK(glm::all(glm::lessThanEqual(node.bounds.min, boxes[item].min)));
      CHECK(glm::all(glm::greaterThanEqual(node.bounds.max, boxes[item].max)));
    }
  }
  CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<std::ptrdiff_t>(boxes.size()));
}

TEST_CASE("a scene without primitives is traced, and few primitives need no hierarchy") {
  Counters counters;
  CHECK_FALSE(Tracing(SceneBuilder().scene, {}).closest({{0, 0, 0}, {0, 0, 1}}, counters));
  CHECK_FALSE(Tracing(test::cornellBox().scene, {}).hasHierarchy());
}

TEST_CASE("of equal distances the lower primitive index wins") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1)));
  b.box({-1, -1, -1}, {1, 1, 1}).quad({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1});
  b.plane({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  Counters counters;
  CHECK(Tracing(b.scene, {}).closest({{0.5, 0.2, 4}, {0, 0, -1}}, counters).primitive == 0);
  std::swap(b.scene.primitives[0], b.scene.primitives[3]);
  CHECK(Tracing(b.scene, {}).closest({{0.5, 0.2, 4}, {0, 0, -1}}, counters).primitive == 0);
  CHECK(counters.traversalSteps == 8);
}

TEST_CASE("one-sided rendering drops the backs of opaque triangles and planes, and of nothing else") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1)));
  b.triangle({-9, -9, 5}, {9, -9, 5}, {0, 9, 5});  // front towards +z
  b.plane({0, 0, 4}, {1, 0, 4}, {0, 1, 4});        // the same
  b.box({-1, -1, 2}, {1, 1, 3}).sphere({0, 0, 0}, 1);
  b.material(test::glassMaterial(vec3(1), 1.5f)).triangle({-9, -9, 1.2f}, {9, -9, 1.2f}, {0, 9, 1.2f});
  const Tracing twoSided(b.scene, withAccel(AccelKind::bvh)), oneSided(b.scene, withAccel(AccelKind::bvh, true));
  Counters counters;
  const auto first = [&](const Tracing& tracing, double z, double dz) {
    return tracing.closest({{0, 0, z}, {0, 0, dz}}, counters).primitive;
  };
  CHECK(first(twoSided, 3.5, 1) == 1);
  CHECK(first(oneSided, 3.5, 1) == kNoPrimitive);
  CHECK(first(oneSided, 9, -1) == 0);
  CHECK(first(oneSided, 4.5, -1) == 1);
  CHECK(first(oneSided, 0, 1) == 3);
  CHECK(first(oneSided, 1.5, -1) == 4);
  CHECK(first(oneSided, 1.4, 1) == 2);
  CHECK(oneSided.closest({{5, -5, 0}, {0, 0, 1}}, counters).primitive == 4);  // the back of glass
  CHECK(twoSided.isOccluded({{5, -5, 3}, {0, 0, 1}}, 8, kNoPrimitive, counters));
  CHECK_FALSE(oneSided.isOccluded({{5, -5, 3}, {0, 0, 1}}, 8, kNoPrimitive, counters));
}

TEST_CASE("shadow rays see neither their light nor what lies at its distance or behind") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1))).sphere({0, 0, 3}, 1).plane({0, 0, 4}, {1, 0, 4}, {0, 1, 4});
  const Tracing tracing(b.scene, {});
  Counters counters;
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  CHECK(tracing.isOccluded(ray, 4, kNoPrimitive, counters));
  CHECK_FALSE(tracing.isOccluded(ray, 4, 0, counters));
  CHECK_FALSE(tracing.isOccluded(ray, 2, kNoPrimitive, counters));
  CHECK(tracing.isOccluded(ray, 2.0001, kNoPrimitive, counters));
}
