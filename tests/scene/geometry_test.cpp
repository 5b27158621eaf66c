// Conversion of statements to primitives: order, orientation, splitting.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/formats/loading/triangles.h"
#include "tests/formats/nff/scene_text.h"

namespace candela::scene {
namespace {

constexpr const char* kLamp = "f 0 0 0 1 0 0 0 0 1 0 1 1 1 1\n";

glm::dvec3 areaVectorOf(const Triangle& t) {
  const glm::dvec3 a = t.p[0];
  return glm::cross(glm::dvec3(t.p[1]) - a, glm::dvec3(t.p[2]) - a) / 2.0;
}

}  // namespace

TEST_CASE("primitives are in the order of the file") {
  const Scene scene = sceneOf(
      "s 0 0 0 1\nbox 0 0 0 1 1 1\np 4 0 0 0 1 0 0 1 1 0 0 1 0\nc 0 0 0 1 0 0 1 1\npl 0 0 0 1 0 0 0 1 0\ns 1 0 0 1\n");
  const std::vector<PrimitiveKind> expected{PrimitiveKind::sphere,   PrimitiveKind::box,  PrimitiveKind::triangle,
                                            PrimitiveKind::triangle, PrimitiveKind::cone, PrimitiveKind::plane,
                                            PrimitiveKind::sphere};
  REQUIRE(scene.primitives.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(scene.primitives[i].kind == expected[i]);
  CHECK(scene.primitives[3].index == 1);
  CHECK(scene.primitives[6].index == 1);
}

TEST_CASE("a mesh counts vertices from 1, and from the end with negative indices") {
  const Scene scene = sceneOf("mesh 4 2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 2 3\n-1 -4 3\n");
  REQUIRE(trianglesOf(scene).size() == 2);
  CHECK(trianglesOf(scene).at(0).p[2] == glm::vec3(0, 1, 0));
  CHECK(trianglesOf(scene).at(1).p[0] == glm::vec3(0, 0, 1));
  CHECK(trianglesOf(scene).at(1).p[1] == glm::vec3(0, 0, 0));
  CHECK(trianglesOf(scene).at(1).p[2] == glm::vec3(0, 1, 0));
}

TEST_CASE("an emitting box becomes twelve triangles that face outwards and cover it") {
  const Scene scene = sceneOf(std::string(kLamp) + "box -1 -2 -3  1 2 3\n");
  CHECK(scene.boxes.empty());
  REQUIRE(trianglesOf(scene).size() == 12);
  double area = 0;
  for (const Triangle& t : trianglesOf(scene)) {
    const glm::dvec3 a = areaVectorOf(t);
    const glm::dvec3 centre = (glm::dvec3(t.p[0]) + glm::dvec3(t.p[1]) + glm::dvec3(t.p[2])) / 3.0;
    CHECK(glm::dot(a, centre) > 0);  // the box is centred on the origin
    area += glm::length(a);
  }
  CHECK(area == Approx(2 * (2 * 4 + 2 * 6 + 4 * 6)));
}

TEST_CASE("a flat emitting box emits from one face, and one without area from none") {
  const Scene flat = sceneOf(std::string(kLamp) + "box 0 0 5  2 3 5\n");
  REQUIRE(trianglesOf(flat).size() == 2);
  CHECK(areaVectorOf(trianglesOf(flat).at(0)).z == Approx(3));
  CHECK(areaVectorOf(trianglesOf(flat).at(1)).z == Approx(3));
  CHECK(sceneOf(std::string(kLamp) + "box 0 0 5  2 0 5\n").primitives.empty());
}

TEST_CASE("a box of zero thickness and a triangle without area are preserved") {
  const Scene scene = sceneOf("box 0 0 0  1 1 0\np 3  0 0 0  1 1 1  2 2 2\np 3 1 1 1 1 1 1 1 1 1\n");
  CHECK(scene.boxes.size() == 1);
  CHECK(trianglesOf(scene).size() == 2);
}

TEST_CASE("a box with swapped corners is sorted, with a warning") {
  const LoadedScene loaded = load("box 1 0 1  0 1 0\n");
  CHECK(loaded.scene.boxes[0].min == glm::vec3(0));
  CHECK(loaded.scene.boxes[0].max == glm::vec3(1));
  CHECK(warningWith(loaded, "swapped").line == 1);
}

TEST_CASE("a patch has a unit normal at each vertex") {
  const Scene scene = sceneOf("pp 4\n0 0 0 0 0 2\n1 0 0 3 0 4\n1 1 0 0 0 1\n0 1 0 0 0 1\n");
  REQUIRE(trianglesOf(scene).size() == 2);
  REQUIRE(vertexNormalsOf(scene).size() == 2);
  for (const Primitive& primitive : scene.primitives) {
    const Triangle t = triangleOf(scene, primitive);
    const VertexNormals normals = vertexNormalsOf(scene, primitive);
    for (int i = 0; i < 3; ++i) {
      const bool tilted = t.p[i] == glm::vec3(1, 0, 0);
      CHECK(normals.n[i] == (tilted ? glm::vec3(.6f, 0, .8f) : glm::vec3(0, 0, 1)));
    }
  }
}

TEST_CASE("a plane in Hessian form contains the points with n . p + d = 0 and faces along n") {
  for (const glm::vec3 n : {glm::vec3(0, 0, 1), {0, 0, -1}, {0, 2, 0}, {-1, 0, 0}, {1, 2, -2}, {.3f, -.4f, .5f}}) {
    for (const float d : {0.f, -3.f, 250.f}) {
      CAPTURE(n.x, n.y, n.z, d);
      const Plane plane = sceneOf(fmt::format("npl {} {} {} {}\n", n.x, n.y, n.z, d)).planes.at(0);
      const double length = glm::length(glm::dvec3(n));
      for (const glm::vec3& p : plane.p) {
        const double distance = (glm::dot(glm::dvec3(n), glm::dvec3(p)) + static_cast<double>(d)) / length;
        CHECK(std::abs(distance) < 1e-7 * (1 + std::abs(static_cast<double>(d)) / length));
      }
      const glm::dvec3 normal = areaVectorOf({{plane.p[0], plane.p[1], plane.p[2]}});
      CHECK(glm::dot(glm::normalize(normal), glm::dvec3(n)) / length > 1 - 1e-12);
    }
  }
}

TEST_CASE("the negative radius of a sphere is preserved") { CHECK(sceneOf("s 0 0 0 -2\n").spheres[0].radius == -2); }

}  // namespace candela::scene
