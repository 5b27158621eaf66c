// Polygons are split without losing or adding area.
#include "host/formats/loading/triangulate.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

namespace candela::scene {
namespace {

using Polygon = std::vector<glm::vec3>;

/// Maps (x, y) to a tilted plane far from the origin.
glm::vec3 tilted(double x, double y) {
  const glm::dvec3 u = glm::normalize(glm::dvec3(2, 1, -1));
  const glm::dvec3 v = glm::normalize(glm::cross(glm::dvec3(1, 3, 5), u));
  return glm::vec3(glm::dvec3(100, -50, 20) + x * u + y * v);
}

glm::dvec3 areaVector(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a) / 2.0;
}

/// Checks that the triangles turn as the polygon does and that their areas sum to `area`.
void checkSplit(const Polygon& polygon, double area, bool expectSimple = true) {
  const Triangulation split = triangulate(polygon);
  CHECK(split.simple == expectSimple);
  CHECK(split.triangles.size() <= polygon.size() - 2);
  glm::dvec3 whole(0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) whole += areaVector(polygon[0], polygon[i], polygon[i + 1]);
  double sum = 0;
  for (const auto& [a, b, c] : split.triangles) {
    const glm::dvec3 vector = areaVector(polygon[a], polygon[b], polygon[c]);
    CHECK(glm::dot(vector, whole) >= -1e-7 * glm::dot(whole, whole));  // a sliver may tilt as vertices are rounded
    sum += glm::length(vector);
  }
  CHECK(sum == Approx(area).epsilon(1e-4));
}

/// `teeth` trapezoids: 4 vertices each, alternating between two radii, as a plane polygon in a tilted plane.
Polygon gear(int teeth, double inner, double outer) {
  Polygon polygon;
  for (int i = 0; i < 4 * teeth; ++i) {
    const double angle = 2 * std::numbers::pi * i / (4 * teeth);
    const double radius = i % 4 < 2 ? outer : inner;
    polygon.push_back(tilted(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return polygon;
}

/// Sum over the sectors between neighbouring vertices: r s sin(step) / 2.
double gearArea(int teeth, double inner, double outer) {
  const double sectors = outer * outer + 2 * inner * outer + inner * inner;
  return teeth * sectors * std::sin(2 * std::numbers::pi / (4 * teeth)) / 2;
}

Polygon reversed(Polygon polygon) {
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

}  // namespace

TEST_CASE("a triangle stays as it is, degenerate or not") {
  CHECK(triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).triangles == triangulate(Polygon(3)).triangles);
}

TEST_CASE("a convex quad becomes two triangles") {
  checkSplit({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, 2);
  CHECK(triangulate(Polygon{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}).triangles.size() == 2);
}

TEST_CASE("an arrowhead is split at its notch, wherever the polygon begins") {
  Polygon arrow{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
  for (int i = 0; i < 4; ++i) {
    checkSplit(arrow, 1);
    checkSplit(reversed(arrow), 1);
    std::rotate(arrow.begin(), arrow.begin() + 1, arrow.end());
  }
}

TEST_CASE("the triangles of a concave 144-gon have its area and orientation") {
  const Polygon polygon = gear(36, 0.8, 1);
  REQUIRE(polygon.size() == 144);
  checkSplit(polygon, gearArea(36, 0.8, 1));
  checkSplit(reversed(polygon), gearArea(36, 0.8, 1));
  CHECK(triangulate(polygon).triangles.size() == 142);
}

TEST_CASE("a gear of four thousand vertices is split too") { checkSplit(gear(1000, 0.5, 1), gearArea(1000, 0.5, 1)); }

TEST_CASE("the triangles of a spiral have its area") {
  // A band of width 1 wound around the origin: out along radius 2 + t, back along 1 + t, t = angle / 2 pi * 1.5.
  constexpr int kSteps = 200;
  const auto radiusAt = [](int i) { return 1 + 1.5 * i / 50.0; };
  const auto angleAt = [](int i) { return 2 * std::numbers::pi * i / 50; };
  Polygon polygon;
  for (int i = 0; i <= kSteps; ++i) {
    const double r = radiusAt(i) + 1;
    polygon.push_back(tilted(r * std::cos(angleAt(i)), r * std::sin(angleAt(i))));
  }
  for (int i = kSteps; i >= 0; --i) {
    const double r = radiusAt(i);
    polygon.push_back(tilted(r * std::cos(angleAt(i)), r * std::sin(angleAt(i))));
  }
  double area = 0;  // sectors of the outer less those of the inner line
  const double sine = std::sin(2 * std::numbers::pi / 50) / 2;
  for (int i = 0; i < kSteps; ++i) {
    area += sine * ((radiusAt(i) + 1) * (radiusAt(i + 1) + 1) - radiusAt(i) * radiusAt(i + 1));
  }
  checkSplit(polygon, area);
}

TEST_CASE("vertices on a straight edge, doubled vertices and spikes change nothing") {
  checkSplit({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}}, 4);
  checkSplit({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}}, 4);
  checkSplit({{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 4);
}

TEST_CASE("a hole that is connected by a pair of coincident edges stays a hole") {
  checkSplit(
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}},
      12);
}

TEST_CASE("polygons are split in each coordinate plane, from both sides") {
  for (int axis = 0; axis < 3; ++axis) {
    Polygon shape;
    for (const glm::dvec2 p : {glm::dvec2(0, 0), {3, 0}, {3, 3}, {2, 1}, {0, 3}}) {
      glm::vec3 vertex(7);
      vertex[(axis + 1) % 3] = static_cast<float>(p.x);
      vertex[(axis + 2) % 3] = static_cast<float>(p.y);
      shape.push_back(vertex);
    }
    checkSplit(shape, 6);  // shoelace: 9 + 3 (3*1 - 2*3 = -3, 2*3 - 0*1 = 6): (9 - 3 + 6) / 2
    checkSplit(reversed(shape), 6);
  }
}

TEST_CASE("a polygon that crosses itself causes a warning and still covers its parts") {
  const Polygon bowTie{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2.5f, 0}};
  CHECK_FALSE(triangulate(bowTie).simple);
  CHECK(triangulate(bowTie).triangles.size() == 2);
  CHECK_FALSE(triangulate(Polygon{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}).simple);  // equal lobes: area 0
  Polygon pentagram;
  for (int i = 0; i < 5; ++i) {
    const double angle = 4 * std::numbers::pi * i / 5;
    pentagram.push_back(tilted(std::cos(angle), std::sin(angle)));
  }
  CHECK_FALSE(triangulate(pentagram).simple);
}

// With a full search for ears after every forced cut, this case takes minutes.
TEST_CASE("a polygon of 16384 random vertices is split, and its triangles have its area vector") {
  std::mt19937 random(1);
  const auto coordinate = [&] { return static_cast<float>(random() % 4096); };
  Polygon polygon;
  for (int i = 0; i < 16384; ++i) polygon.emplace_back(coordinate(), coordinate(), 0.0f);
  const Triangulation split = triangulate(polygon);
  CHECK_FALSE(split.simple);
  CHECK(split.triangles.size() > 16000);
  glm::dvec3 whole(0), sum(0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) whole += areaVector(polygon[0], polygon[i], polygon[i + 1]);
  for (const auto& [a, b, c] : split.triangles) sum += areaVector(polygon[a], polygon[b], polygon[c]);
  CHECK(sum == whole);  // multiples of 1/2 below 2^53
}

TEST_CASE("a polygon without area gives triangles without area") {
  const Triangulation split = triangulate(Polygon{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}});
  CHECK(split.simple);
  CHECK(split.triangles.size() == 2);
}

TEST_CASE("the deviation from the plane is measured against the extent") {
  CHECK(triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).planeDeviation == 0);
  CHECK(triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {1, 1, .5f}, {0, 1, 0}}).planeDeviation > 0.1);
}

}  // namespace candela::scene
