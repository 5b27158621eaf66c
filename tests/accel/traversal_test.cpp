// A plain traversal in double precision finds in the tree what brute force finds, ties included.
#include <catch2/catch.hpp>

#include "host/accel/bvh.h"
#include "tests/accel/inputs.h"
#include "tests/accel/ray_tests.h"

using namespace candela;
using namespace candela::test;

namespace {

struct Hit {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t primitive = ~0u;
  bool operator==(const Hit&) const = default;

  // Of equal distances the lower primitive index wins.
  void offer(double otherT, std::uint32_t other) {
    if (otherT < t || (otherT == t && other < primitive)) *this = {otherT, other};
  }
};

void addSphere(Scene& scene, const glm::dvec3& centre, double radius) {
  scene.primitives.push_back({PrimitiveKind::sphere, static_cast<std::uint32_t>(scene.spheres.size()), 0});
  scene.spheres.push_back({glm::vec3(centre), static_cast<float>(radius)});
}

void addTriangle(Scene& scene, const glm::vec3& p0, const glm::vec3& p1, const glm::vec3& p2) {
  scene.primitives.push_back({PrimitiveKind::triangle, static_cast<std::uint32_t>(scene.triangles.size()), 0});
  scene.triangles.push_back({{p0, p1, p2}});
}

// Triangle soup, spheres of all sizes, smallpt's walls, and half of everything twice: those pairs tie.
Scene makeScene() {
  Random random(21);
  Scene scene;
  for (int i = 0; i < 120; ++i) {
    const glm::vec3 p(random.inCube(0, 100));
    addTriangle(scene, p, p + glm::vec3(random.inCube(-20, 20)), p + glm::vec3(random.inCube(-20, 20)));
    addSphere(scene, random.inCube(0, 100), std::exp2(random.real(-4, 4)));
    if (i % 2 == 0) continue;
    const Triangle triangle = scene.triangles.back();
    addTriangle(scene, triangle.p[0], triangle.p[1], triangle.p[2]);
    const Sphere sphere = scene.spheres.back();
    addSphere(scene, glm::dvec3(sphere.centre), double{sphere.radius});
  }
  addSphere(scene, {1e5 + 1, 40.8, 81.6}, 1e5);
  addSphere(scene, {50, 1e5, 81.6}, 1e5);
  return scene;
}

Hit bruteForce(const Ray<double>& ray, const Scene& scene) {
  Hit best;
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    if (const auto t = intersect(ray, scene, scene.primitives[i])) best.offer(*t, i);
  }
  return best;
}

Hit traverse(const Ray<double>& ray, const Scene& scene, const Bvh& bvh, std::uint64_t& testCount) {
  const SlabRay<double> slabs(ray);
  Hit best;
  std::vector<std::uint32_t> stack = {0};
  while (!stack.empty()) {
    const BvhNode& node = bvh.nodes[stack.back()];
    stack.pop_back();
    if (!slabs.enter(node.bounds, best.t)) continue;
    if (!node.isLeaf()) {
      stack.push_back(node.first);
      stack.push_back(node.first + 1);
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t primitive = bvh.primitiveIndices[i];
      ++testCount;
      if (const auto t = intersect(ray, scene, scene.primitives[primitive])) best.offer(*t, primitive);
    }
  }
  return best;
}

}  // namespace

TEST_CASE("the tree finds the same nearest primitive as brute force for 100,000 rays") {
  const Scene scene = makeScene();
  const Bvh bvh = buildBvh(boundPrimitives(scene).bounds);
  Random random(22);
  int hits = 0, differing = 0, ties = 0;
  std::uint64_t testCount = 0;
  constexpr int kRays = 100000;
  for (int i = 0; i < kRays; ++i) {
    const Ray<double> ray{random.inCube(-20, 120), random.direction()};
    const Hit expected = bruteForce(ray, scene);
    if (traverse(ray, scene, bvh, testCount) != expected) ++differing;
    if (expected.primitive == ~0u) continue;
    ++hits;
    const std::size_t behind = expected.primitive + 2;  // where makeScene() puts a twin
    if (behind < scene.primitives.size() && intersect(ray, scene, scene.primitives[behind]) == expected.t) ++ties;
  }
  CHECK(differing == 0);
  CHECK(hits > kRays / 2);
  CHECK(ties > kRays / 20);
  // A tree that is no use would test every primitive.
  CHECK(testCount < kRays * scene.primitives.size() / 10);
}
