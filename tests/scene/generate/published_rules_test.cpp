// Published rules of the databases beyond the sizes of the published files.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "tests/formats/loading/triangles.h"
#include "tests/scene/generate/generated_text.h"

namespace candela {
namespace {

using Heights = std::map<std::pair<float, float>, float>;

/// z over x and y, of all vertices.
Heights heightsOf(const scene::Scene& scene) {
  Heights heights;
  for (const scene::Triangle& triangle : trianglesOf(scene)) {
    for (const glm::vec3& p : triangle.p) {
      const auto [place, isNew] = heights.insert({{p.x, p.y}, p.z});
      REQUIRE((isNew || place->second == p.z));  // neighbours agree about their common vertices
    }
  }
  return heights;
}

bool touch(const scene::Sphere& a, const scene::Sphere& b) {
  const double distance = glm::length(glm::dvec3(a.centre) - glm::dvec3(b.centre));
  return std::abs(distance - (a.radius + b.radius)) < 1e-5;
}

}  // namespace

TEST_CASE("every ball but the first touches its parent, which has three times its radius") {
  const std::vector<scene::Sphere> balls = generatedScene("balls", 3).scene.spheres;
  for (std::size_t i = 1; i < balls.size(); ++i) {
    const bool hasParent = std::any_of(
        balls.begin(), balls.begin() + static_cast<std::ptrdiff_t>(i),
        [&](const scene::Sphere& p) { return std::abs(p.radius - 3 * balls[i].radius) < 1e-5 && touch(p, balls[i]); });
    CAPTURE(i);
    CHECK(hasParent);
  }
}

TEST_CASE("a larger mountain refines a smaller one, also beyond size 7") {
  for (const auto& [coarse, fine] : {std::pair{2u, 3u}, {4u, 6u}, {7u, 8u}}) {
    CAPTURE(coarse, fine);
    const Heights rough = heightsOf(generatedScene("mount", coarse).scene);
    const Heights smooth = heightsOf(generatedScene("mount", fine).scene);
    const std::size_t side = (std::size_t{1} << coarse) + 1;
    CHECK(rough.size() == side * side);
    for (const auto& [place, height] : rough) REQUIRE(smooth.at(place) == height);
  }
}

TEST_CASE("the mountain's rim is displaced and its corners are not") {
  const Heights heights = heightsOf(generatedScene("mount", 3).scene);
  for (const float x : {-1.f, 1.f}) {
    for (const float y : {-1.f, 1.f}) CHECK(heights.at({x, y}) == 0);
  }
  CHECK(heights.at({0.f, -1.f}) != 0);
}

TEST_CASE("tetra's triangles are equilateral, of one size, and face outwards") {
  const scene::Scene scene = generatedScene("tetra", 3).scene;
  const double side = 2 * std::sqrt(2.0) / 4;
  const std::vector<scene::Triangle> triangles = trianglesOf(scene);
  for (std::size_t i = 0; i < triangles.size(); i += 4) {
    glm::dvec3 middle(0);
    for (std::size_t face = i; face < i + 4; ++face) {
      for (const glm::vec3& p : triangles[face].p) middle += glm::dvec3(p) / 12.0;
    }
    for (std::size_t face = i; face < i + 4; ++face) {
      const glm::dvec3 a = triangles[face].p[0], b = triangles[face].p[1], c = triangles[face].p[2];
      for (const double length : {glm::length(a - b), glm::length(b - c), glm::length(c - a)}) {
        CHECK(length == Approx(side).epsilon(1e-6));
      }
      CHECK(glm::dot(glm::cross(b - a, c - a), a - middle) > 0);
    }
  }
}

TEST_CASE("meshing gears do not touch, and are offset by half a tooth") {
  const scene::Scene scene = generatedScene("gears", 2).scene;
  const std::size_t trianglesOfGear = 2 * 142 + 144 * 2;
  const std::vector<scene::Triangle> triangles = trianglesOf(scene);
  REQUIRE(triangles.size() == 2 + 8 * trianglesOfGear);
  const auto greatest = [&](std::size_t gear, int axis) {
    float result = -1e9f;
    for (std::size_t i = 0; i < trianglesOfGear; ++i) {
      for (const glm::vec3& p : triangles[2 + gear * trianglesOfGear + i].p) result = std::max(result, p[axis]);
    }
    return result;
  };
  CHECK(greatest(0, 2) == 1);     // the upper layer's upper face
  CHECK(greatest(4, 2) == 0.5);   // the lower layer, half of the cube below
  CHECK(greatest(1, 0) > 0.99f);  // the cube of gears is [-1, 1] wide
  CHECK(greatest(1, 0) < 1);
  CHECK(greatest(0, 0) != Approx(greatest(2, 0)));  // tooth against gap: neighbours are turned by half a tooth
}

TEST_CASE("the sombrero is cos(2 pi r) exp(-r), sampled a little denser than its vertices lie") {
  constexpr int kPoints = 64;
  const scene::Scene scene = generatedScene("sombrero", 2).scene;
  for (const scene::Triangle& triangle : trianglesOf(scene)) {
    for (const glm::vec3& p : triangle.p) {
      const double column = std::round((p.x + 4.0) / 8 * (kPoints - 1));
      const double row = std::round((p.z + 4.0) / 8 * (kPoints - 1));
      const double x = -4 + 8 * column / kPoints;
      const double z = -4 + 8 * row / kPoints;
      const double r = std::sqrt(x * x + z * z);
      REQUIRE(std::abs(p.y - (-3 + std::cos(2 * std::numbers::pi * r) * std::exp(-r))) < 2e-5);
    }
  }
}

TEST_CASE("the teapot's normals are unit and point to the front of its triangles") {
  const scene::Scene scene = generatedScene("teapot", 8).scene;
  CHECK(vertexNormalsOf(scene).size() == 64 * 8 * 8 - 8 * 8);
  for (const scene::Primitive& primitive : scene.primitives) {
    if (!isSmooth(scene, primitive)) continue;
    const scene::Triangle triangle = triangleOf(scene, primitive);
    const scene::VertexNormals normals = vertexNormalsOf(scene, primitive);
    const glm::dvec3 a = triangle.p[0], b = triangle.p[1], c = triangle.p[2];
    const glm::dvec3 front = glm::cross(b - a, c - a);
    for (const glm::vec3& normal : normals.n) {
      REQUIRE(glm::length(glm::dvec3(normal)) == Approx(1).epsilon(1e-5));
      REQUIRE(glm::dot(front, glm::dvec3(normal)) > 0);
    }
  }
}

}  // namespace candela
