// Placements of instances: exact values, rounding in the order of the specification, and limits.
#include "host/scene/placement.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "host/scene/scene.h"

namespace candela::scene {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::vec3;
using glm::vec4;

constexpr float kStep = 0x1p-24f;  // half an ulp of 1

dmat4 scaling(const dvec3& factors) { return glm::scale(dmat4(1), factors); }

TEST_CASE("a placement applies products from left to right, and then the translation") {
  Placement placement{{vec4(1, 1, 1, 0), vec4(0, 1, 0, 0), vec4(0, 0, 1, 0)}, {}};
  CHECK(placedPoint(placement, {kStep, 1, kStep}).x == 1.0f);           // (2^-24 + 1) + 2^-24: both are rounded off
  CHECK(placedPoint(placement, {kStep, kStep, 1}).x == 1 + 2 * kStep);  // (2^-24 + 2^-24) + 1 is exact
  placement.points[0].w = kStep;
  CHECK(placedPoint(placement, {kStep, 0, 1}).x == 1.0f);
  CHECK(placedPoint(placement, {2 * kStep, 0, 1}).x == 1 + 4 * kStep);  // a tie: rounded to even
}

TEST_CASE("the identity and translations place points exactly") {
  const std::optional<Placement> moved = placementOf(glm::translate(dmat4(1), dvec3(1, -2, 3)));
  REQUIRE(moved);
  CHECK(placedPoint(*moved, {0.5f, 0.25f, -8}) == vec3(1.5f, -1.75f, -5));
  CHECK(placedNormal(*moved, {0, 0.6f, 0.8f}) == vec3(0, 0.6f, 0.8f));
  CHECK(placedTangent(*moved, {0.6f, 0, 0.8f, -1}) == vec4(0.6f, 0, 0.8f, -1));
}

TEST_CASE("normals stay perpendicular to surfaces, on the same side, whatever the map") {
  dmat4 shear(1);
  shear[1][0] = 0.75;
  for (const dmat4& map : {scaling({2, 3, 0.25}), scaling({-2, 1, 1}), scaling({-1, -1, -1}), shear}) {
    const std::optional<Placement> placement = placementOf(map);
    REQUIRE(placement);
    const vec3 edge1(1, 0.5f, 0), edge2(0.25f, 1, 2);
    const vec3 normal = placedNormal(*placement, glm::normalize(glm::cross(edge1, edge2)));
    const vec3 placed1 = placedPoint(*placement, edge1), placed2 = placedPoint(*placement, edge2);
    CHECK(std::abs(glm::dot(normal, placed1)) < 1e-6f);
    CHECK(std::abs(glm::dot(normal, placed2)) < 1e-6f);
    const vec3 geometric = glm::cross(placed1, placed2) * (mirrors(map) ? -1.0f : 1.0f);
    CHECK(glm::dot(normal, geometric) > 0);
  }
}

TEST_CASE("maps that are nearly singular or not finite have no placement") {
  CHECK(placementOf(scaling({1, 1, 400})));
  CHECK_FALSE(placementOf(scaling({1, 1, 500})));  // 9 * 500 > 4096
  CHECK(placementOf(scaling(dvec3(1e-3))));
  CHECK(placementOf(scaling(dvec3(1e3))));
  CHECK_FALSE(placementOf(scaling({1, 1, 0})));
  CHECK_FALSE(placementOf(dmat4(0)));
  CHECK_FALSE(placementOf(scaling({1, 1, std::nan("")})));
  CHECK_FALSE(placementOf(scaling(dvec3(1e300))));
}

TEST_CASE("the triangles of an instance are those of its mesh, placed") {
  Scene scene;
  scene.meshes.push_back({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                          .normals = {{0, 0, 1}, {0, 0, 1}, {0, 0.6f, 0.8f}},
                          .tangents = {{1, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}});
  scene.placements.push_back(*placementOf(glm::translate(dmat4(1), dvec3(0, 0, 5)) * scaling({2, 1, 1})));
  const Primitive placed(PrimitiveKind::triangle, 0, 0, 0, 0), unplaced(PrimitiveKind::triangle, 0, 0);
  CHECK(triangleOf(scene, unplaced).p[1] == vec3(1, 0, 0));
  CHECK(triangleOf(scene, placed).p[1] == vec3(2, 0, 5));
  CHECK(glm::normalize(vertexNormalsOf(scene, placed).n[0]) == vec3(0, 0, 1));
  CHECK(vertexNormalsOf(scene, unplaced).n[2] == vec3(0, 0.6f, 0.8f));
  CHECK(vertexTangentsOf(scene, placed)[0] == vec4(2, 0, 0, 1));
  CHECK(vertexTangentsOf(scene, unplaced)[0] == vec4(1, 0, 0, 1));
}

}  // namespace
}  // namespace candela::scene
