// Boxes of primitives: their positions, that they contain the surface, and that they are tight.
#include "host/trace/accel/primitive_bounds.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "host/base/errors.h"
#include "tests/trace/accel/inputs.h"

using namespace candela;
using namespace candela::accel;
using candela::test::Random;

namespace {

scene::Scene sceneOf(const scene::Cone& cone) {
  scene::Scene scene;
  scene.cones = {cone};
  scene.primitives = {{scene::PrimitiveKind::cone, 0, 0}};
  return scene;
}

// The box with `exact` faces may be wider by the pad and the rounding of each face, never narrower.
void checkPadded(const Aabb& box, const glm::dvec3& min, const glm::dvec3& max) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::max({largest, std::abs(min[i]), std::abs(max[i])});
  const double pad = largest / 524288, rounding = largest / 4194304;
  for (int i = 0; i < 3; ++i) {
    INFO("axis " << i);
    CHECK(double{box.min[i]} <= min[i] - pad);
    CHECK(double{box.min[i]} >= min[i] - pad - rounding);
    CHECK(double{box.max[i]} >= max[i] + pad);
    CHECK(double{box.max[i]} <= max[i] + pad + rounding);
  }
}

}  // namespace

TEST_CASE("the box of each kind of primitive is padded by 2^-19 of its largest coordinate") {
  scene::Scene scene;
  scene.spheres = {{{1, 2, 3}, 0.5f}, {{1, 2, 3}, -0.5f}, {{1e5f + 1, 40.8f, 81.6f}, 1e5f}};
  scene.meshes = {{.positions = {{0, 1, 0}, {2, -1, 5}, {-3, 0, 1}}}};
  scene.boxes = {{{0, 0, 0}, {0, 0, 0}}, {{-1, 2, 3}, {4, 2, 6}}};
  scene.primitives = {{scene::PrimitiveKind::sphere, 0, 0}, {scene::PrimitiveKind::sphere, 1, 0},
                      {scene::PrimitiveKind::sphere, 2, 0}, {scene::PrimitiveKind::triangle, 0, 0},
                      {scene::PrimitiveKind::box, 0, 0},    {scene::PrimitiveKind::box, 1, 0}};
  const std::vector<Aabb> boxes = boundPrimitives(scene).bounds;
  REQUIRE(boxes.size() == 6);
  checkPadded(boxes[0], {0.5, 1.5, 2.5}, {1.5, 2.5, 3.5});
  checkPadded(boxes[1], {0.5, 1.5, 2.5}, {1.5, 2.5, 3.5});
  const double y = double{40.8f}, z = double{81.6f};
  checkPadded(boxes[2], {1, y - 1e5, z - 1e5}, {200001, y + 1e5, z + 1e5});
  checkPadded(boxes[3], {-3, -1, 0}, {2, 1, 5});
  checkPadded(boxes[4], {0, 0, 0}, {0, 0, 0});
  checkPadded(boxes[5], {-1, 2, 3}, {4, 2, 6});
}

TEST_CASE("a cone's box is that of its two circles") {
  // Along z the circles lie flat; along x + y they lean by 45 degrees: r / sqrt 2 in x and y, r in z.
  checkPadded(boundPrimitives(sceneOf({{1, 1, 1}, 2, {1, 1, 5}, 0.5f})).bounds[0], {-1, -1, 1}, {3, 3, 5});
  const double lean = std::numbers::sqrt2 / 2;
  checkPadded(boundPrimitives(sceneOf({{0, 0, 0}, 1, {3, 3, 0}, 2})).bounds[0], {-lean, -lean, -2},
              {3 + 2 * lean, 3 + 2 * lean, 2});
}

TEST_CASE("random cones touch every face of their boxes and are inside them") {
  Random random(3);
  for (int n = 0; n < 200; ++n) {
    const scene::Cone cone{glm::vec3(random.inCube(-5, 5)), static_cast<float>(random.real(0, 2)),
                           glm::vec3(random.inCube(-5, 5)), static_cast<float>(random.real(0, 2))};
    const Aabb box = boundPrimitives(sceneOf(cone)).bounds[0];
    const glm::dvec3 w = glm::normalize(glm::dvec3(cone.apex) - glm::dvec3(cone.base));
    const glm::dvec3 u = glm::normalize(glm::cross(w, std::abs(w.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 v = glm::cross(w, u);
    glm::dvec3 min(1e9), max(-1e9);
    for (int i = 0; i < 2000; ++i) {
      const double phi = i * std::numbers::pi / 1000;
      const glm::dvec3 rim = std::cos(phi) * u + std::sin(phi) * v;
      for (const auto& [centre, radius] : {std::pair(cone.base, cone.baseRadius), {cone.apex, cone.apexRadius}}) {
        min = glm::min(min, glm::dvec3(centre) + double{radius} * rim);
        max = glm::max(max, glm::dvec3(centre) + double{radius} * rim);
      }
    }
    const glm::dvec3 slackBelow = min - glm::dvec3(box.min), slackAbove = glm::dvec3(box.max) - max;
    const double least = std::min({slackBelow.x, slackBelow.y, slackBelow.z, slackAbove.x, slackAbove.y, slackAbove.z});
    const double most = std::max({slackBelow.x, slackBelow.y, slackBelow.z, slackAbove.x, slackAbove.y, slackAbove.z});
    REQUIRE(least >= 0);
    REQUIRE(most < 1e-4);  // the pad is 2e-5 at most, and 2000 steps miss an extreme by 5e-6
  }
}

TEST_CASE("infinite planes are separate, and boxes refer to their primitives") {
  scene::Scene scene;
  scene.spheres = {{{0, 0, 0}, 1}, {{5, 0, 0}, 1}};
  scene.planes.push_back({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  scene.primitives = {
      {scene::PrimitiveKind::sphere, 0, 0}, {scene::PrimitiveKind::plane, 0, 0}, {scene::PrimitiveKind::sphere, 1, 0}};
  const SceneBounds result = boundPrimitives(scene);
  CHECK(result.finite == std::vector<std::uint32_t>{0, 2});
  CHECK(result.infinite == std::vector<std::uint32_t>{1});
  REQUIRE(result.bounds.size() == 2);
  CHECK(result.bounds[1].min.x == Approx(4));
  CHECK_FALSE(primitiveBounds(scene, scene.primitives[1]).has_value());
}

TEST_CASE("a primitive too far away to be traced is refused, and the message names its scene") {
  scene::Scene scene;
  scene.name = "far.p3f";
  scene.spheres = {{{0, 1e11f, 0}, 1}, {{0, 0, -1e12f}, 2e11f}};
  scene.primitives = {{scene::PrimitiveKind::sphere, 0, 0}};
  CHECK_NOTHROW(boundPrimitives(scene));
  scene.primitives.push_back({scene::PrimitiveKind::sphere, 1, 0});
  CHECK_THROWS_WITH(boundPrimitives(scene), Catch::StartsWith("far.p3f: a primitive reaches beyond"));
  CHECK_THROWS_AS(boundPrimitives(scene), FileError);
}
