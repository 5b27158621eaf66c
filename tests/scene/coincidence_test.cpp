// The search for surfaces that exist twice or overlap in one plane.
#include "host/scene/coincidence.h"

#include <catch2/catch.hpp>

#include "tests/reference/scene_builder.h"

using namespace candela;
using glm::vec3;
using scene::Coincidences;
using scene::findCoincidences;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

SceneBuilder grey() {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.5f)));
  return b;
}

std::size_t copyCount(const Coincidences& found) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < found.firstCopy.size(); ++i) count += found.firstCopy[i] != i;
  return count;
}

void addGrid(SceneBuilder& b, int side, const vec3& corner, const vec3& u, const vec3& v) {
  const auto at = [&](int x, int y) { return corner + static_cast<float>(x) * u + static_cast<float>(y) * v; };
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) b.quad(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
  }
}

}  // namespace

TEST_CASE("triangles with the same vertices are copies in any order") {
  const vec3 p[3] = {{0, 0, 1}, {3, 0.5f, 0}, {1, 2, 0.25f}};
  SceneBuilder b = grey();
  b.triangle(p[0], p[1], p[2]).triangle(p[1], p[2], p[0]).triangle(p[2], p[1], p[0]).triangle(p[0], p[1], {1, 2, 0.5f});
  const Coincidences found = findCoincidences(b.scene);
  CHECK(found.firstCopy == std::vector<std::uint32_t>{0, 0, 0, 3});
  CHECK(found.coincident == std::vector<bool>{true, true, true, false});
  CHECK(found.overlaps.empty());
  CHECK(found.any());
}

TEST_CASE("equal spheres, boxes, planes and cones are copies, cones also with their ends exchanged") {
  SceneBuilder b = grey();
  b.sphere({1, 2, 3}, 2).sphere({1, 2, 3}, -2).sphere({1, 2, 3}, 2.5f);
  b.cone({5, 0, 0}, 1, {5, 0, 4}, 2).cone({5, 0, 4}, 2, {5, 0, 0}, 1).cone({5, 0, 4}, 1, {5, 0, 0}, 2);
  b.box({-9, 0, 0}, {-8, 1, 1}).box({-9, 0, 0}, {-8, 1, 1});
  b.plane({0, 0, -4}, {1, 0, -4}, {0, 1, -4}).plane({0, 0, -4}, {1, 0, -4}, {0, 1, -4});
  const Coincidences found = findCoincidences(b.scene);
  CHECK(found.firstCopy == std::vector<std::uint32_t>{0, 0, 2, 3, 3, 5, 6, 6, 8, 8});
  CHECK(found.coincident == std::vector<bool>{true, true, false, true, true, false, true, true, true, true});
}

TEST_CASE("flat surfaces of every kind that overlap in one plane are found, at any scale") {
  const float scale = GENERATE(1e-3f, 1.0f, 1e6f);
  SceneBuilder b = grey();
  const auto at = [&](float x, float y, float z) { return scale * vec3(x, y, z); };
  b.plane(at(0, 0, 1), at(1, 0, 1), at(0, 1, 1));                 // 0
  b.triangle(at(-1, -1, 1), at(3, -1, 1), at(0, 3, 1));           // 1
  b.triangle(at(0, 2, 1), at(0, 0, 1), at(1, 0, 1));              // 2
  b.box(at(-2, -2, 0), at(0, 0, 1));                              // 3
  b.box(at(-3, -1, 1), at(-0.5f, 1, 2));                          // 4
  b.triangle(at(0, 0, 1.01f), at(1, 0, 1.01f), at(0, 1, 1.01f));  // 5: above
  b.triangle(at(0.1f, 0, 1), at(1, 0, 1), at(0.1f, 1, 1.2f));     // 6: inclined
  b.triangle(at(9, 9, 5), at(10, 9, 5), at(9, 10, 5));            // 7: alone
  const Coincidences found = findCoincidences(b.scene);
  CAPTURE(scale);
  CHECK(found.overlaps == std::vector<Pair>{{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}, {3, 4}});
  CHECK(copyCount(found) == 0);
}

TEST_CASE("parallel planes with a gap above the tolerance do not coincide") {
  for (const float coordinate : {1.0f, 10.0f, 1000.0f}) {
    SceneBuilder b = grey();
    const float above = coordinate + std::max(5.0f, coordinate) * 0x1p-19f;
    b.quad({-5, -5, coordinate}, {5, -5, coordinate}, {5, 5, coordinate}, {-5, 5, coordinate});
    b.quad({-4, -4, above}, {4, -4, above}, {4, 4, above}, {-4, 4, above});
    CAPTURE(coordinate);
    CHECK_FALSE(findCoincidences(b.scene).any());
  }
}

TEST_CASE("a rug whose vertices are rounded to other numbers than those of its floor lies in its plane") {
  // A floor of 1 km that is inclined: a rug of 1 m in its plane has vertices rounded to steps of 6e-8 or 6e-5.
  const auto onFloor = [](double x, double y) { return vec3(glm::dvec3(x, y, 0.123456789 * x - 0.0456789123 * y)); };
  for (const double at : {0.3, 40.7, 471.1}) {
    SceneBuilder b = grey();
    b.quad(onFloor(-1000, -1000), onFloor(1000, -1000), onFloor(1000, 1000), onFloor(-1000, 1000));
    b.triangle(onFloor(at, 2), onFloor(at + 1.1, 2.3), onFloor(at + 0.2, 3.7));
    CAPTURE(at);
    CHECK(findCoincidences(b.scene).coincident[2]);
  }
}

TEST_CASE("rugs near the origin lie in the plane of a floor whose distant vertices are rounded by more than theirs") {
  const auto onFloor = [](double x, double y) { return vec3(glm::dvec3(x, y, 0.723456789 * x - 0.6456789123 * y)); };
  for (int i = 0; i < 8; ++i) {
    for (const bool floorFirst : {false, true}) {
      SceneBuilder b = grey();
      const auto addFloor = [&] {
        b.triangle(onFloor(-1000.3 - 9 * i, -907.1), onFloor(1103.7, -1000.9), onFloor(4.1, 1000.3 + 7 * i));
      };
      if (floorFirst) addFloor();
      b.triangle(onFloor(-0.2, -0.13), onFloor(0.17, -0.11), onFloor(0.03, 0.21));
      if (!floorFirst) addFloor();
      CAPTURE(i, floorFirst);
      CHECK(findCoincidences(b.scene).coincident == std::vector<bool>{true, true});
    }
  }
}

TEST_CASE(
    "a rug above a level floor by half of the tolerance lies in its plane, and by twice the tolerance it does not") {
  const auto coincide = [](float tolerances) {
    SceneBuilder b = grey();
    const float z = 1000 * 0x1p-21f * tolerances;
    b.triangle({-1000, -1000, 0}, {1000, -1000, 0}, {0, 1000, 0});
    b.triangle({-1, -1, z}, {1, -1, z}, {0, 1, z});
    return findCoincidences(b.scene).any();
  };
  CHECK(coincide(0.5f));
  CHECK_FALSE(coincide(2));
}

TEST_CASE("planes at an angle or at a distance do not coincide") {
  SceneBuilder b = grey();
  b.plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0})
      .plane({0, 0, 0}, {0, 0, 1}, {0, 1, 0})
      .plane({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  b.plane({0, 0, 0}, {1, 0, 1e-6f}, {0, 1, 0});
  CHECK_FALSE(findCoincidences(b.scene).any());
}

TEST_CASE("neighbours in a flat mesh, in a closed box and at an acute edge do not coincide") {
  SceneBuilder b = grey();
  addGrid(b, 40, {0.1f, 0.2f, 0.3f}, {0.1f, 0.017f, 0.003f}, {-0.02f, 0.1f, 0.011f});
  b.box({5, 5, 5}, {6, 6, 6}).box({6, 5, 5.5f}, {7, 7, 8});
  b.quad({100, 0, 0}, {110, 0, 0}, {110, 10, 0}, {100, 10, 0});
  b.quad({100, 0, 0}, {110, 0, 0}, {110, 10, 0.5f}, {100, 10, 0.5f});
  const Coincidences found = findCoincidences(b.scene);
  CHECK(copyCount(found) == 0);
  // Only the boxes, whose faces at x = 6 share a part, coincide.
  CHECK(found.overlaps == std::vector<Pair>{{3200, 3201}});
}

TEST_CASE("a flat mesh that exists twice, once displaced in its plane, is found whole") {
  SceneBuilder b = grey();
  addGrid(b, 30, {0, 0, 1}, {0.1f, 0, 0}, {0, 0.1f, 0});
  addGrid(b, 30, {0.04f, 0.03f, 1}, {0.1f, 0, 0}, {0, 0.1f, 0});
  const Coincidences found = findCoincidences(b.scene);
  CHECK(std::count(found.coincident.begin(), found.coincident.end(), true) == 3600);
  CHECK_FALSE(found.truncated);
}

TEST_CASE("a search that would compare too many pairs ends and counts every flat surface") {
  // Triangles that share a vertex and lie in different planes, so that no partition of space separates them.
  SceneBuilder b = grey();
  for (int i = 0; i < 30000; ++i) {
    const float angle = 0.0002f * static_cast<float>(i);
    b.triangle({-1, -1, -1}, {1, std::cos(angle), std::sin(angle)}, {1, 1 + std::sin(angle), 1});
  }
  b.sphere({5, 5, 5}, 1);
  const Coincidences found = findCoincidences(b.scene);
  CHECK(found.truncated);
  CHECK(std::count(found.coincident.begin(), found.coincident.end(), true) == 30000);
  CHECK_FALSE(found.coincident[30000]);
}
