// Objects whose surfaces coincide, counted and named.
#include "host/scene/coincidence/coincident_objects.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/trace/reference/scene_builder.h"

namespace candela::scene {
namespace {

using glm::vec3;
using test::SceneBuilder;

// A square at a height, as an object of its own.
class Squares : public SceneBuilder {
 public:
  Squares() { material(test::diffuseMaterial(vec3(0.5f))); }

  Squares& square(const std::string& name, float from, float to, float height = 0) {
    scene.objectStarts.push_back(static_cast<std::uint32_t>(scene.primitives.size()));
    if (!name.empty()) scene.objectNames.push_back(name);
    quad({from, from, height}, {to, from, height}, {to, to, height}, {from, to, height});
    return *this;
  }
};

std::vector<std::string> linesOf(const Scene& scene) { return linesOf(coincidentObjects(scene)); }

}  // namespace

TEST_CASE("nodes whose surfaces coincide are named with the numbers of their triangles") {
  Squares b;
  b.square("Floor", 0, 4).square("Floor.001", 0, 4).square("Rug", 2, 3).square("Lid", 0, 4, 1);
  CHECK(linesOf(b.scene) == std::vector<std::string>{
                                "6 primitives in 2 pairs of objects",
                                "2 triangles of object Floor.001 coincide with 2 triangles of object Floor",
                                "2 triangles of object Rug overlap 2 triangles of object Floor in one plane",
                            });
  CHECK(coincidentObjects(b.scene).primitiveCount == 6u);
}

TEST_CASE("the word node does not stand before a name that begins with it") {
  Squares b;
  b.square("node.7", 0, 4).square("node.8", 0, 4);
  CHECK(linesOf(b.scene) ==
        std::vector<std::string>{"2 triangles of object node.8 coincide with 2 triangles of object node.7"});
}

TEST_CASE("an object whose surfaces coincide with each other, and another one of its name, are told apart") {
  Squares b;
  b.square("Floor", 0, 4).quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0});
  CHECK(linesOf(b.scene) ==
        std::vector<std::string>{"2 triangles of object Floor coincide with 2 other triangles of the same object"});
  CHECK(coincidentObjects(b.scene).pairs.front().isOne);
  Squares two;
  two.square("Floor", 0, 4).square("Floor", 0, 4);
  CHECK(linesOf(two.scene) ==
        std::vector<std::string>{"2 triangles of object Floor coincide with 2 triangles of another object Floor"});
  CHECK_FALSE(coincidentObjects(two.scene).pairs.front().isOne);
}

TEST_CASE("a pair of objects with copies and overlaps has one line") {
  Squares b;
  b.square("A", 0, 4).square("B", 0, 4).triangle({1, 0.5f, 0}, {2, 0.5f, 0}, {2, 0.75f, 0});
  CHECK(linesOf(b.scene) ==
        std::vector<std::string>{
            "2 triangles of object B coincide with 2 triangles of object A, and 1 triangle overlaps 1 "
            "triangle in one plane"});
}

TEST_CASE("objects without names have those of their kinds, and several kinds are primitives") {
  Squares b;
  b.square("", 0, 4).square("", 0, 4, 3);
  b.scene.objectStarts.push_back(4);
  b.box({1, 1, 0}, {3, 3, 3});
  b.scene.objectStarts.push_back(5);
  b.sphere({9, 9, 9}, 1);
  b.scene.objectStarts.push_back(6);
  b.sphere({9, 9, 9}, 1).box({1, 1, 3}, {2, 2, 4}).triangle({1, 1, 3}, {2, 1, 3}, {1, 2, 3});
  const std::vector<std::string> lines = linesOf(b.scene);
  REQUIRE(lines.size() > 4);
  CHECK(lines.front() == "9 primitives in 6 pairs of objects");
  for (const char* line : {"1 box of object box.2 overlaps 2 triangles of object triangle.0 in one plane",
                           "1 sphere of object sphere.4 coincides with 1 sphere of object sphere.3",
                           "2 primitives of object sphere.4 overlap 2 triangles of object triangle.1 in one plane"}) {
    CAPTURE(line, lines);
    CHECK(std::find(lines.begin(), lines.end(), line) != lines.end());
  }
}

TEST_CASE("the first eight pairs of objects are listed, those with most primitives first") {
  Squares b;
  for (int i = 0; i < 10; ++i) {
    const auto height = static_cast<float>(i);
    b.square("A" + std::to_string(i), 0, 4, height).square("B" + std::to_string(i), 0, 4, height);
  }
  b.quad({0, 0, 9}, {4, 0, 9}, {4, 4, 9}, {0, 4, 9});
  const std::vector<std::string> lines = linesOf(b.scene);
  REQUIRE(lines.size() == 10);
  CHECK(lines[0] == "42 primitives in 10 pairs of objects");
  CHECK(lines[1] == "4 triangles of object B9 coincide with 2 triangles of object A9");
  CHECK(lines[2] == "2 triangles of object B0 coincide with 2 triangles of object A0");
  CHECK(lines[9] == "and 2 more pairs, which the report in JSON lists");
}

TEST_CASE("a scene whose search ended early says so") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(0.5f))).sphere({0, 0, 0}, 1).sphere({0, 0, 0}, 1);
  for (int i = 0; i < 10000; ++i) {
    const auto height = static_cast<float>(i);
    b.plane({0, 0, height}, {1, 0, height}, {0, 1, height});
  }
  const CoincidenceReport report = coincidentObjects(b.scene);
  CHECK_FALSE(report.primitiveCount);
  CHECK(linesOf(report) ==
        std::vector<std::string>{"the search for surfaces that overlap in one plane ended after too many comparisons; "
                                 "only equal surfaces are listed",
                                 "1 sphere of object scene coincides with 1 other sphere of the same object"});
}

TEST_CASE("instances are named with the numbers of their triangles, also where all of them are copies") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(0.5f)));
  const std::uint32_t mesh = storeMesh(
      b.scene, {.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, .indices = {0, 1, 2, 0, 2, 3}});
  const auto show = [&](const char* name, double x) {
    b.scene.objectStarts.push_back(static_cast<std::uint32_t>(b.scene.primitives.size()));
    b.scene.objectNames.emplace_back(name);
    glm::dmat4 map(1);
    map[3].x = x;
    addInstance(b.scene, mesh, placementOf(map).value(), 0);
  };
  show("Tile", 0), show("Tile.001", 0), show("Tile.002", 0.5), show("Tile.003", 9);
  CHECK(linesOf(b.scene) == std::vector<std::string>{
                                "6 primitives in 2 pairs of objects",
                                "2 triangles of object Tile.001 coincide with 2 triangles of object Tile",
                                "2 triangles of object Tile.002 overlap 2 triangles of object Tile in one plane",
                            });
}

}  // namespace candela::scene
