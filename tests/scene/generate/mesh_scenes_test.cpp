// The kinds that are not from the databases: a height field, a closed surface in a closed room, and two balls in the
// Cornell box.
#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "host/formats/load_scene.h"
#include "tests/formats/loading/triangles.h"
#include "tests/scene/generate/generated_text.h"

namespace candela {
namespace {

using Point = std::tuple<float, float, float>;
using Edge = std::pair<Point, Point>;

Point key(const glm::vec3& p) { return {p.x, p.y, p.z}; }

/// Returns for each edge from a to b its excess over the edge from b to a.
std::map<Edge, int> unmatchedEdges(std::span<const scene::Triangle> triangles) {
  std::map<Edge, int> edges;
  for (const scene::Triangle& triangle : triangles) {
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

glm::dvec3 normalOf(const scene::Triangle& triangle) {
  const glm::dvec3 a = triangle.p[0], b = triangle.p[1], c = triangle.p[2];
  return glm::cross(b - a, c - a);
}

using Colour = std::tuple<float, float, float>;
using Corner = std::tuple<Point, Colour, Colour>;  ///< position, the surface's colour, its emission

/// Corners of the triangles of a scene from `first` on, which must be diffuse. Lights have no colour here: those
/// of `al` statements are black.
std::set<Corner> cornersOf(const scene::Scene& scene, std::size_t first, std::size_t count) {
  std::set<Corner> corners;
  for (std::size_t i = first; i < first + count; ++i) {
    const scene::Material& material = scene.materials[scene.primitives[i].material];
    REQUIRE(kindOf(material) == scene::MaterialKind::diffuse);
    CHECK(material.diffuse->weight == 1);
    const glm::vec3 colour = isEmissive(material) ? glm::vec3(0) : material.diffuse->colour;
    const scene::Triangle triangle = triangleOf(scene, scene.primitives[i]);
    for (const glm::vec3& p : triangle.p) {
      corners.insert({key(p), key(colour), key(material.emission)});
    }
  }
  return corners;
}

}  // namespace

TEST_CASE("the terrain is 100 wide, between 0 and 35 high, and faces up") {
  const scene::Scene scene = generatedScene("terrain", 64).scene;
  glm::vec3 least(1e9f), greatest(-1e9f);
  for (const scene::Triangle& triangle : trianglesOf(scene)) {
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

TEST_CASE("the terrain is the same landscape at every size") {
  const auto heightAt = [](const scene::Scene& scene, const glm::vec2& place) {
    for (const scene::Triangle& triangle : trianglesOf(scene)) {
      for (const glm::vec3& p : triangle.p) {
        if (glm::vec2(p) == place) return p.z;
      }
    }
    return -1.f;
  };
  const scene::Scene coarse = generatedScene("terrain", 11).scene;
  const scene::Scene fine = generatedScene("terrain", 101).scene;
  for (const glm::vec2& place : {glm::vec2(-50, -50), {10, -20}, {40, 50}}) {
    CHECK(heightAt(coarse, place) > 0);
    CHECK(heightAt(coarse, place) == heightAt(fine, place));
  }
}

TEST_CASE("the bumpy sphere is closed, faces outwards and lies within its room") {
  for (const std::uint32_t size : {1u, 2u, 9u, 76u}) {
    CAPTURE(size);
    const scene::Scene scene = generatedScene("sphere", size).scene;
    const std::vector<scene::Triangle> all = trianglesOf(scene);
    const auto sphere = std::span(all).last(12 * size * size);
    CHECK(unmatchedEdges(sphere).empty());
    const glm::dvec3 centre(0, 0, 1.8);
    for (const scene::Triangle& triangle : sphere) {
      REQUIRE(glm::dot(normalOf(triangle), glm::dvec3(triangle.p[0]) - centre) > 0);
      for (const glm::vec3& p : triangle.p) {
        const double radius = glm::length(glm::dvec3(p) - centre);
        REQUIRE((radius > 0.999 && radius < 1.601));
      }
    }
  }
}

TEST_CASE("the room with its light is closed and faces inwards") {
  const scene::Scene scene = generatedScene("sphere", 1).scene;
  const std::vector<scene::Triangle> all = trianglesOf(scene);
  const auto room = std::span(all).first(20);
  CHECK(unmatchedEdges(room).empty());
  for (const scene::Triangle& triangle : room) {
    CHECK(glm::dot(normalOf(triangle), glm::dvec3(0, 0, 1.8) - glm::dvec3(triangle.p[0])) > 0);
  }
  std::size_t shining = 0;
  for (const scene::Primitive& primitive : scene.primitives) {
    shining += isEmissive(scene.materials[primitive.material]) ? 1 : 0;
  }
  CHECK(shining == 2);
}

TEST_CASE("the balls of the Cornell box are closed, face outwards, and touch neither walls nor each other") {
  const std::array<glm::dvec3, 2> centres{{{380, 101, 370}, {175, 101, 180}}};
  for (const std::uint32_t size : {1u, 2u, 29u}) {
    CAPTURE(size);
    const scene::Scene scene = generatedScene("cornell", size).scene;
    const std::vector<scene::Triangle> all = trianglesOf(scene);
    const auto balls = std::span(all).subspan(18);
    for (std::size_t i = 0; i < 2; ++i) {
      const std::span<const scene::Triangle> ball = balls.subspan(i * 12 * size * size, 12 * size * size);
      CHECK(unmatchedEdges(ball).empty());
      for (const scene::Triangle& triangle : ball) {
        REQUIRE(glm::dot(normalOf(triangle), glm::dvec3(triangle.p[0]) - centres[i]) > 0);
        for (const glm::vec3& p : triangle.p) {
          REQUIRE(glm::length(glm::dvec3(p) - centres[i]) == Approx(100).epsilon(1e-5));
          REQUIRE(glm::all(glm::greaterThan(p, glm::vec3(0))));
          REQUIRE(glm::all(glm::lessThan(p, glm::vec3(549.6, 548.8, 559.2))));  // the narrowest width, height, depth
        }
      }
    }
  }
  CHECK(glm::length(centres[0] - centres[1]) > 2 * 100);
}

TEST_CASE("one ball of the Cornell box is a mirror, and the other is glass") {
  const scene::Scene scene = generatedScene("cornell", 1).scene;
  const scene::Material& mirror = scene.materials[scene.primitives[18].material];
  const scene::Material& glass = scene.materials[scene.primitives[18 + 12].material];
  CHECK(kindOf(mirror) == scene::MaterialKind::mirror);
  REQUIRE(kindOf(glass) == scene::MaterialKind::dielectric);
  CHECK(glass.dielectric->ior == 1.5f);
}

TEST_CASE("the box and the light around the balls are those of scenes/cornell.p3f, open only at the front") {
  const scene::Scene box = generatedScene("cornell", 1).scene;
  const scene::Scene original = formats::loadScene(std::filesystem::path(CANDELA_SOURCE_DIR) / "scenes/cornell.p3f")
                                    .scene;
  CHECK(cornersOf(box, 0, 18) == cornersOf(original, 0, 18));
  const std::vector<scene::Triangle> triangles = trianglesOf(box);
  const std::map<Edge, int> open = unmatchedEdges(std::span(triangles).first(18));
  CHECK(open.size() == 4);
  for (const auto& [edge, surplus] : open) {
    CHECK(std::get<2>(edge.first) == 0);
    CHECK(std::get<2>(edge.second) == 0);
  }
}

}  // namespace candela
