// Rules that decide which hit counts: ties, sides, and shadow rays.
#include <catch2/catch.hpp>

#include "host/trace/reference/tracing.h"
#include "tests/trace/reference/default_settings.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::reference;
using glm::vec3;
using test::SceneBuilder;

TEST_CASE("a scene without primitives can be traced, and few primitives have no BVH") {
  Counters counters;
  CHECK_FALSE(Tracing(SceneBuilder().scene, render::defaultSettings()).closest({{0, 0, 0}, {0, 0, 1}}, counters));
  CHECK_FALSE(Tracing(test::cornellBox().scene, render::defaultSettings()).hasHierarchy());
}

TEST_CASE("at equal distances the lower primitive index is hit") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1)));
  b.box({-1, -1, -1}, {1, 1, 1}).quad({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1});
  b.plane({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  Counters counters;
  CHECK(Tracing(b.scene, render::defaultSettings()).closest({{0.5, 0.2, 4}, {0, 0, -1}}, counters).primitive == 0);
  const scene::PrimitiveList& own = b.scene.primitives;
  b.scene.primitives = {own[3], own[1], own[2], own[0]};
  CHECK(Tracing(b.scene, render::defaultSettings()).closest({{0.5, 0.2, 4}, {0, 0, -1}}, counters).primitive == 0);
  CHECK(counters.traversalSteps == 8);
}

TEST_CASE("one-sided rendering ignores the backs of opaque triangles and planes, and of no other primitives") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1)));
  b.triangle({-9, -9, 5}, {9, -9, 5}, {0, 9, 5});  // front towards +z
  b.plane({0, 0, 4}, {1, 0, 4}, {0, 1, 4});        // the same
  b.box({-1, -1, 2}, {1, 1, 3}).sphere({0, 0, 0}, 1);
  b.material(test::glassMaterial(vec3(1), 1.5f)).triangle({-9, -9, 1.2f}, {9, -9, 1.2f}, {0, 9, 1.2f});
  render::RenderSettings settings = render::defaultSettings();
  settings.structure.accel = render::AccelKind::bvh;
  const Tracing twoSided(b.scene, settings);
  settings.image.oneSided = true;
  const Tracing oneSided(b.scene, settings);
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
  CHECK(twoSided.isOccluded({{5, -5, 3}, {0, 0, 1}}, {8}, counters));
  CHECK_FALSE(oneSided.isOccluded({{5, -5, 3}, {0, 0, 1}}, {8}, counters));
}

TEST_CASE("shadow rays ignore their light and everything at or beyond its distance") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1))).sphere({0, 0, 3}, 1).plane({0, 0, 4}, {1, 0, 4}, {0, 1, 4});
  const Tracing tracing(b.scene, render::defaultSettings());
  Counters counters;
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  CHECK(tracing.isOccluded(ray, {4}, counters));
  CHECK_FALSE(tracing.isOccluded(ray, {4, 0}, counters));
  CHECK_FALSE(tracing.isOccluded(ray, {2}, counters));
  CHECK(tracing.isOccluded(ray, {2.0001}, counters));
}
