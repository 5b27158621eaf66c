// The two kinds of Candela's own: a height field and a closed surface in a closed room.
#include <catch2/catch.hpp>
#include <map>
#include <tuple>

#include "tests/generate/generated_text.h"

namespace candela {
namespace {

using Point = std::tuple<float, float, float>;
using Edge = std::pair<Point, Point>;

Point key(const glm::vec3& p) { return {p.x, p.y, p.z}; }

/// Of each edge from a to b: how often there is one more of it than of b to a.
std::map<Edge, int> unmatchedEdges(std::span<const Triangle> triangles) {
  std::map<Edge, int> edges;
  for (const Triangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) {
      const Point a = key(triangle.p[i]);
      const Point b = key(triangle.p[(i + 1) % 3]);
      const bool ordered = a < b;
      edges[ordered ? Edge(a, b) : Edge(b, a)] += ordered ? 1 : -1;
    }
  }
  std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
  return edges;
}

glm::dvec3 normalOf(const Triangle& triangle) {
  const glm::dvec3 a = triangle.p[0], b = triangle.p[1], c = triangle.p[2];
  return glm::cross(b - a, c - a);
}

}  // namespace

TEST_CASE("terrain is 100 wide, between 0 and 35 high, and faces up") {
  const Scene scene = generatedScene("terrain", 64).scene;
  glm::vec3 least(1e9f), greatest(-1e9f);
  for (const Triangle& triangle : scene.triangles) {
    CHECK(normalOf(triangle).z > 0);
    for (const glm::vec3& p : triangle.p) {
      least = glm::min(least, p);
      greatest = glm::max(greatest, p);
    }
  }
  CHECK(glm::vec2(least) == glm::vec2(-50));
  CHECK(glm::vec2(greatest) == glm::vec2(50));
  CHECK(least.z >= 0);
  CHECK(greatest.z < 35);
  CHECK(greatest.z - least.z > 15);
}

TEST_CASE("terrain is the same landscape at every size") {
  const auto heightAt = [](const Scene& scene, const glm::vec2& place) {
    for (const Triangle& triangle : scene.triangles) {
      for (const glm::vec3& p : triangle.p) {
        if (glm::vec2(p) == place) return p.z;
      }
    }
    return -1.f;
  };
  const Scene coarse = generatedScene("terrain", 11).scene;
  const Scene fine = generatedScene("terrain", 101).scene;
  for (const glm::vec2& place : {glm::vec2(-50, -50), {10, -20}, {40, 50}}) {
    CHECK(heightAt(coarse, place) > 0);
    CHECK(heightAt(coarse, place) == heightAt(fine, place));
  }
}

TEST_CASE("the bumpy sphere is closed, faces outwards and lies within its room") {
  for (const std::uint32_t size : {1u, 2u, 9u, 76u}) {
    CAPTURE(size);
    const Scene scene = generatedScene("sphere", size).scene;
    const std::span<const Triangle> all = scene.triangles;
    const std::span<const Triangle> sphere = all.last(12 * size * size);
    CHECK(unmatchedEdges(sphere).empty());
    const glm::dvec3 centre(0, 0, 1.8);
    for (const Triangle& triangle : sphere) {
      REQUIRE(glm::dot(normalOf(triangle), glm::dvec3(triangle.p[0]) - centre) > 0);
      for (const glm::vec3& p : triangle.p) {
        const double radius = glm::length(glm::dvec3(p) - centre);
        REQUIRE((radius > 0.999 && radius < 1.601));
      }
    }
  }
}

TEST_CASE("the room with its lamp is closed and faces inwards") {
  const Scene scene = generatedScene("sphere", 1).scene;
  const std::span<const Triangle> all = scene.triangles;
  const std::span<const Triangle> room = all.first(20);
  CHECK(unmatchedEdges(room).empty());
  for (const Triangle& triangle : room) {
    CHECK(glm::dot(normalOf(triangle), glm::dvec3(0, 0, 1.8) - glm::dvec3(triangle.p[0])) > 0);
  }
  std::size_t shining = 0;
  for (const Primitive& primitive : scene.primitives) {
    shining += isEmissive(scene.materials[primitive.material]) ? 1 : 0;
  }
  CHECK(shining == 2);
}

}  // namespace candela
