// Tangents computed as by MikkTSpace, compared with values computed by hand.
#include "host/formats/loading/mikk_tangents.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace candela;
using namespace candela::scene;
using glm::vec2;
using glm::vec3;
using glm::vec4;

namespace {

// A unit square in the plane z = 0 that faces up, as two triangles. The image's top is at its far edge.
Mesh unitSquare() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.texCoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

// Two triangles that share the edge from (0 0 0) to (0 2 0): one in the plane z = 0 to the right, with a right angle at
// (0 0 0), the other upright to the left, with half of it. The texture continues across the edge.
Mesh bentSheet() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 2, 2}};
  mesh.normals.assign(4, glm::normalize(vec3(1, 0, 1)));
  mesh.texCoords[0] = {{0, 0}, {1, 0}, {0, -1}, {-1, -1}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

void requireNear(const vec4& tangent, const vec4& expected) {
  CAPTURE(tangent.x, tangent.y, tangent.z, tangent.w);
  CHECK(glm::length(tangent - expected) < 1e-6f);
}

}  // namespace

TEST_CASE("tangents point to the right of an upright image, and bitangents to its top") {
  for (const vec4& tangent : mikkTangents(unitSquare(), {})) requireNear(tangent, {1, 0, 0, 1});
}

TEST_CASE("an image that is mirrored has handedness -1") {
  Mesh mesh = unitSquare();
  for (vec2& uv : mesh.texCoords[0]) uv.x = -uv.x;
  for (const vec4& tangent : mikkTangents(mesh, {})) requireNear(tangent, {-1, 0, 0, -1});
}

TEST_CASE("tangents follow the reference's set and transform of coordinates") {
  Mesh mesh = unitSquare();
  std::swap(mesh.texCoords[0], mesh.texCoords[1]);
  const TextureReference turned{.texCoordSet = 1, .rowS = {0, -1, 0}, .rowT = {1, 0, 0}};  // s grows to the far edge
  for (const vec4& tangent : mikkTangents(mesh, turned)) requireNear(tangent, {0, 1, 0, 1});
  for (const vec4& tangent : mikkTangents(mesh, {})) CHECK(vec3(tangent) == vec3(0));
}

TEST_CASE("tangents are perpendicular to the vertex normal") {
  // The tangents of the triangles are (1 0 0) and (0 0 -1).
  for (const vec4& tangent : mikkTangents(bentSheet(), {}))
    requireNear(tangent, vec4(glm::normalize(vec3(1, 0, -1)), 1));
}

TEST_CASE("a vertex has the mean of its triangles' tangents, weighted by their angles") {
  Mesh mesh = bentSheet();
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {-2, 2, 0}};  // angles of 90 and 45 degrees at the first vertex
  mesh.normals.assign(4, {0, 0, 1});
  mesh.texCoords[0] = {{0, 0}, {1, 0}, {0, -1}, {-1, -2}};
  const vec3 first(1, 0, 0);
  const vec3 second = glm::normalize(vec3(1, 1, 0));
  const std::vector<vec4> tangents = mikkTangents(mesh, {});
  requireNear(tangents[1], vec4(first, 1));
  requireNear(tangents[5], vec4(second, 1));
  requireNear(tangents[0], vec4(glm::normalize(2.0f * first + second), 1));
  CHECK(tangents[3] == tangents[0]);
}

TEST_CASE("triangles whose images are mirrored to each other do not share tangents") {
  Mesh mesh = bentSheet();
  mesh.texCoords[0][3] = {1, -1};
  const std::vector<vec4> tangents = mikkTangents(mesh, {});
  CHECK(tangents[0].w == 1);
  CHECK(tangents[3].w == -1);
  CHECK(vec3(tangents[0]) != vec3(tangents[3]));
}

TEST_CASE("a triangle whose coordinates have no area takes tangents from those that it continues, or has none") {
  Mesh mesh = bentSheet();
  mesh.texCoords[0][3] = {0, -2};  // on the line through the shared edge
  const std::vector<vec4> tangents = mikkTangents(mesh, {});
  CHECK(tangents[3] == tangents[0]);
  CHECK(tangents[4] == tangents[2]);
  CHECK(vec3(tangents[5]) == vec3(0));
  CHECK(tangents[5].w == 1);
}

TEST_CASE("triangles without area have no tangents, and meshes without normals those of flat triangles") {
  Mesh mesh = bentSheet();
  mesh.normals.clear();
  mesh.indices = {0, 1, 2, 0, 2, 3, 0, 0, 1};
  const std::vector<vec4> tangents = mikkTangents(mesh, {});
  requireNear(tangents[0], {1, 0, 0, 1});
  requireNear(tangents[3], {0, 0, -1, 1});
  CHECK(vec3(tangents[6]) == vec3(0));
}

TEST_CASE("tangents are finite for coordinates that are not") {
  Mesh mesh = unitSquare();
  mesh.texCoords[0][1].x = std::numeric_limits<float>::infinity();
  mesh.texCoords[0][3].y = std::numeric_limits<float>::quiet_NaN();
  for (const vec4& tangent : mikkTangents(mesh, {})) CHECK(std::isfinite(glm::length(tangent)));
}
