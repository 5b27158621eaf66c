// The guarantee of primitive_bounds.h: no ray that a primitive test accepts, in either precision, misses its box.
#include <catch2/catch.hpp>
#include <numbers>

#include "tests/trace/accel/inputs.h"
#include "tests/trace/accel/ray_tests.h"

using namespace candela;
using namespace candela::accel;
using namespace candela::test;

namespace {

// A position and a size for primitives and rays.
struct Setting {
  const char* name;
  glm::dvec3 centre;
  double scale;
};

const Setting kSettings[] = {
    {"at the origin", {0, 0, 0}, 1},
    {"at the origin, small", {0, 0, 0}, 1e-3},
    {"far away", {148376, 1234, -223423}, 1},
    {"far away, large", {148376, 1234, -223423}, 1e3},
    {"far away, a few float spacings large", {148376, 1234, -223423}, 0.25},
};

glm::dvec3 across(const glm::dvec3& v, Random& random) { return glm::normalize(glm::cross(v, random.direction())); }

// Fills `scene` with one random primitive of `kind` and returns a point of it that rays barely hit or miss: on an
// edge, on a rim or, for a sphere, on the silhouette as seen from `eye`.
glm::dvec3 makePrimitive(scene::PrimitiveKind kind, const Setting& setting, const glm::dvec3& eye, Random& random,
                         scene::Scene& scene) {
  const auto point = [&] { return glm::vec3(setting.centre + setting.scale * random.inCube(-1, 1)); };
  const auto length = [&] { return static_cast<float>(setting.scale * std::exp2(random.real(-10, 0))); };
  scene.primitives = {{kind, 0, 0}};
  switch (kind) {
    case scene::PrimitiveKind::sphere: {
      const scene::Sphere sphere{point(), length()};
      scene.spheres = {sphere};
      const glm::dvec3 toCentre = glm::dvec3(sphere.centre) - eye;
      const double sine = std::min(1.0, double{sphere.radius} / glm::length(toCentre));
      const glm::dvec3 outline = across(toCentre, random) * std::sqrt(1 - sine * sine) -
                                 glm::normalize(toCentre) * sine;
      return glm::dvec3(sphere.centre) + double{sphere.radius} * outline;
    }
    case scene::PrimitiveKind::triangle: {
      const glm::vec3 p = point();
      const float size = length();
      const auto near = [&] { return p + size * glm::vec3(random.direction()); };
      const glm::vec3 second = near(), third = near();
      scene.meshes = {{.positions = {p, second, third}}};
      std::vector<glm::vec3>& corners = scene.meshes[0].positions;
      if (random.real() < 0.2) corners[2].y = corners[1].y = p.y;
      return glm::mix(glm::dvec3(corners[0]), glm::dvec3(corners[1]), std::max(0.0, random.real(-0.2, 1)));
    }
    case scene::PrimitiveKind::box: {
      const Aabb box = boxAround(glm::dvec3(point()), {length(), length(), length()});
      scene.boxes = {{box.min, box.max}};
      return {box.min.x, box.max.y, random.real(double{box.min.z}, double{box.max.z})};
    }
    default: {
      const scene::Cone cone{point(), length(), point(), random.real() < 0.3 ? 0 : length()};
      scene.cones = {cone};
      const glm::dvec3 axis = glm::dvec3(cone.apex) - glm::dvec3(cone.base);
      if (axis == glm::dvec3(0)) scene.primitives.clear();
      return glm::dvec3(cone.base) + double{cone.baseRadius} * across(axis, random);
    }
  }
}

glm::dvec3 makeEye(const Setting& setting, Random& random) {
  const double choice = random.real();
  if (choice < 0.4) return setting.centre + setting.scale * random.inCube(-2, 2);
  if (choice < 0.7) return setting.centre + 1000 * setting.scale * random.direction();
  if (choice < 0.9) return random.inCube(-1, 1);
  return glm::dvec3(0);
}

struct Tally {
  int hits = 0;
  int lost = 0;
};

template <class T>
void count(const Ray<float>& ray, const scene::Scene& scene, const Aabb& box, Tally& tally) {
  const Ray<T> same{Vec<T>(ray.origin), Vec<T>(ray.direction)};
  const auto t = intersect(same, scene, scene.primitives[0]);
  if (!t) return;
  ++tally.hits;
  // The box must not only be hit but hit in time: otherwise the closest hit would still be skipped.
  if (!SlabRay<float>(ray).enter(box, static_cast<float>(*t))) ++tally.lost;
}

}  // namespace

TEST_CASE("no hit at the edge of a primitive is lost by its padded box") {
  constexpr int kRays = 70000;
  for (const scene::PrimitiveKind kind : {scene::PrimitiveKind::sphere, scene::PrimitiveKind::triangle,
                                          scene::PrimitiveKind::box, scene::PrimitiveKind::cone}) {
    for (const Setting& setting : kSettings) {
      INFO("kind " << static_cast<int>(kind) << ", " << setting.name);
      Random random(11);
      Tally exact, rounded;
      for (int i = 0; i < kRays; ++i) {
        scene::Scene scene;
        const glm::vec3 eye(makeEye(setting, random));
        const glm::dvec3 target = makePrimitive(kind, setting, glm::dvec3(eye), random, scene);
        const glm::dvec3 path = target - glm::dvec3(eye);
        if (scene.primitives.empty() || path == glm::dvec3(0)) continue;
        Ray<float> ray{eye, glm::vec3(glm::normalize(path))};
        if (random.real() < 0.1) ray.direction = glm::vec3(0, 0, i % 2 ? 1 : -1);
        const Aabb box = *primitiveBounds(scene, scene.primitives[0]);
        count<double>(ray, scene, box, exact);
        count<float>(ray, scene, box, rounded);
      }
      CHECK(exact.lost == 0);
      CHECK(rounded.lost == 0);
      // Rays at an edge hit about as often as they miss.
      CHECK(exact.hits > kRays / 20);
      CHECK(rounded.hits > kRays / 20);
    }
  }
}

TEST_CASE("hits are lost if boxes are not padded") {
  Random random(12);
  const Setting setting = kSettings[0];
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    scene::Scene scene;
    const glm::vec3 eye(makeEye(setting, random));
    const glm::dvec3 target = makePrimitive(scene::PrimitiveKind::box, setting, glm::dvec3(eye), random, scene);
    const Ray<float> ray{eye, glm::vec3(glm::normalize(target - glm::dvec3(eye)))};
    const auto t = intersect(Ray<double>{ray.origin, ray.direction}, scene.boxes[0]);
    if (!t) continue;
    ++tally.hits;
    SlabRay<float> bare(ray);
    bare.originForMin = bare.originForMax = ray.origin;
    if (!bare.enter({scene.boxes[0].min, scene.boxes[0].max}, static_cast<float>(*t))) ++tally.lost;
  }
  CHECK(tally.hits > 5000);
  CHECK(tally.lost > 10);
}

TEST_CASE("the distance of a needle, clamped to its own box, is never before the entry into a box around it") {
  Random random(14);
  int hits = 0, frontOfOwn = 0, frontOfAncestor = 0;
  for (int i = 0; i < 200000; ++i) {
    const Setting& setting = kSettings[0];
    scene::Scene scene;
    const glm::vec3 eye(makeEye(setting, random));
    const glm::dvec3 target = makePrimitive(scene::PrimitiveKind::triangle, setting, glm::dvec3(eye), random, scene);
    std::vector<glm::vec3>& corners = scene.meshes[0].positions;
    corners[2] = glm::mix(corners[1], corners[2], static_cast<float>(std::exp2(random.real(-20, -6))));
    const Ray<float> ray{eye, glm::vec3(glm::normalize(target - glm::dvec3(eye)))};
    const auto t = intersect(ray, triangleOf(scene, scene.primitives[0]));
    if (!t) continue;
    ++hits;
    const Aabb own = *primitiveBounds(scene, scene.primitives[0]);
    const SlabRay<float> slabs(ray);
    const auto near = slabs.enter(own, SlabRay<float>::kEndless);
    if (!near) continue;  // not hit, whatever surrounds it
    if (*near > *t) ++frontOfOwn;
    Aabb ancestor = own;
    ancestor.extend(boxAround(random.inCube(-1, 1), random.inCube(0, 0.2)));
    if (!slabs.enter(ancestor, std::max(*near, *t))) ++frontOfAncestor;
  }
  CHECK(hits > 50000);
  CHECK(frontOfOwn > 0);  // so the clamp is needed
  CHECK(frontOfAncestor == 0);
}

TEST_CASE("if a box is hit in single precision, its ancestors are hit at no greater distance") {
  Random random(13);
  int accepted = 0;
  bool monotonic = true;
  for (int i = 0; i < 200000; ++i) {
    const Aabb child = boxAround(random.inCube(-1, 1), random.inCube(0, 0.5));
    Aabb parent = child;
    for (int face = 0; face < 3; ++face) {
      if (random.real() < 0.5) parent.min[face] = std::nextafter(parent.min[face], -2.0f);
      if (random.real() < 0.5) parent.max[face] += static_cast<float>(random.real(0, 1e-6));
    }
    const SlabRay<float> ray({glm::vec3(random.inCube(-2, 2)), glm::vec3(random.direction())});
    const auto atChild = ray.enter(child, 100.0f);
    if (!atChild) continue;
    ++accepted;
    const auto atParent = ray.enter(parent, 100.0f);
    monotonic = monotonic && atParent && *atParent <= *atChild;
  }
  CHECK(accepted > 1000);
  CHECK(monotonic);
}
