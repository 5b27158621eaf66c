// The search for surfaces that exist twice or overlap in one plane.
#include "host/scene/coincidence/coincidence.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "host/scene/coincidence/flat_surface.h"
#include "host/scene/shape.h"
#include "tests/scene/coincidence/flat_parts.h"
#include "tests/trace/reference/scene_builder.h"

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

bool anyCoincide(const Coincidences& found) { return std::ranges::count(found.coincident, true) > 0; }

void addGrid(SceneBuilder& b, int side, const vec3& corner, const vec3& u, const vec3& v) {
  const auto at = [&](int x, int y) { return corner + static_cast<float>(x) * u + static_cast<float>(y) * v; };
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) b.quad(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
  }
}

// Compares all pairs of flat parts.
// The scene has no instances, so that primitives are numbered by their indices.
std::vector<std::uint32_t> firstCopiesOf(const scene::Scene& scene) {
  return firstUnplacedCopies(scene, scene::StoredPrimitives(scene.primitives));
}

std::vector<Pair> overlapsByBruteForce(const scene::Scene& scene, const std::vector<std::uint32_t>& firstCopy) {
  const std::vector<scene::FlatSurface> parts = test::flatPartsOf(scene,
                                                                  [&](std::uint32_t i) { return firstCopy[i] == i; });
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < parts.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (parts[a].primitive == parts[b].primitive || !overlapInPlane(parts[a], parts[b])) continue;
      pairs.emplace_back(std::minmax(parts[a].primitive, parts[b].primitive));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// Triangles, boxes and planes in few planes, of sizes that differ by a factor of a thousand, some of them twice.
SceneBuilder crowd(std::uint32_t seed) {
  std::mt19937 numbers(seed);
  const auto random = [&](float scale) { return std::uniform_real_distribution<float>(-scale, scale)(numbers); };
  const auto whole = [&](int end) {
    return static_cast<float>(std::uniform_int_distribution<int>(0, end - 1)(numbers));
  };
  SceneBuilder b = grey();
  for (int i = 0; i < 700; ++i) {
    const vec3 corner(random(9), random(9), whole(4));
    const float size = std::pow(10.0f, random(1.5f) - 1);
    const vec3 u = size * vec3(random(1), random(1), whole(2) * random(1)), v = size * vec3(random(1), random(1), 0);
    b.triangle(corner, corner + u, corner + v);
    if (i % 50 == 0) b.triangle(corner + u, corner + v, corner);
    if (i % 25 == 0) b.box(corner, corner + vec3(size, size, 1 + whole(2)));
    if (i % 100 == 0) b.plane(vec3(0, 0, whole(4)) + random(5), corner + u, corner + v);
    if (i % 150 == 0) b.plane(vec3(random(5), 0, whole(4)), {0, 1, corner.z}, {1, 0, corner.z});
  }
  return b;
}

}  // namespace

TEST_CASE("triangles with the same vertices are copies in any order") {
  const vec3 p[3] = {{0, 0, 1}, {3, 0.5f, 0}, {1, 2, 0.25f}};
  SceneBuilder b = grey();
  b.triangle(p[0], p[1], p[2]).triangle(p[1], p[2], p[0]).triangle(p[2], p[1], p[0]).triangle(p[0], p[1], {1, 2, 0.5f});
  const Coincidences found = findCoincidences(b.scene);
  CHECK(firstCopiesOf(b.scene) == std::vector<std::uint32_t>{0, 0, 0, 3});
  CHECK(found.copies == std::vector<Pair>{{0, 1}, {0, 2}});
  CHECK(found.coincident == std::vector<bool>{true, true, true, false});
  CHECK(found.overlaps.empty());
  CHECK(anyCoincide(found));
}

TEST_CASE("equal spheres, boxes, planes and cones are copies, cones also with their ends exchanged") {
  SceneBuilder b = grey();
  b.sphere({1, 2, 3}, 2).sphere({1, 2, 3}, -2).sphere({1, 2, 3}, 2.5f);
  b.cone({5, 0, 0}, 1, {5, 0, 4}, 2).cone({5, 0, 4}, 2, {5, 0, 0}, 1).cone({5, 0, 4}, 1, {5, 0, 0}, 2);
  b.box({-9, 0, 0}, {-8, 1, 1}).box({-9, 0, 0}, {-8, 1, 1});
  b.plane({0, 0, -4}, {1, 0, -4}, {0, 1, -4}).plane({0, 0, -4}, {1, 0, -4}, {0, 1, -4});
  const Coincidences found = findCoincidences(b.scene);
  CHECK(firstCopiesOf(b.scene) == std::vector<std::uint32_t>{0, 0, 2, 3, 3, 5, 6, 6, 8, 8});
  CHECK(found.copies == std::vector<Pair>{{0, 1}, {3, 4}, {6, 7}, {8, 9}});
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
  CHECK(found.copies.size() == 0);
}

TEST_CASE("what does not emit is ordered where it coincides with emitters") {
  SceneBuilder b = grey();
  b.quad({-4, -4, 3}, {4, -4, 3}, {4, 4, 3}, {-4, 4, 3});      // 0, 1
  b.quad({-1, -1, 3}, {-2, -1, 3}, {-2, -2, 3}, {-1, -2, 3});  // 2, 3: a decal beside the lamp
  b.quad({-4, -4, 3}, {4, -4, 3}, {4, 4, 3}, {-4, 4, 3});      // 4, 5: copies of the ceiling
  b.sphere({9, 0, 0}, 2).sphere({60, 0, 0}, 2);                // 6, 7
  b.material(diffuseMaterial(vec3(0), vec3(1)));
  b.triangle({1, 1, 3}, {2, 1, 3}, {1, 2, 3}).sphere({9, 0, 0}, -2);  // 8, 9
  const Coincidences found = findCoincidences(b.scene);
  // The diagonal of the ceiling from (-4, -4) to (4, 4) divides the lamp.
  CHECK(found.ordered == std::vector<bool>{true, true, false, false, true, true, true, false, false, false});
  CHECK(found.orderReach == 11);
}

TEST_CASE("what may have another place in a plane than what it coincides with is ordered") {
  scene::Material foil;
  foil.surface = scene::SurfaceParameters{.transmissionWeight = 1, .isThinWalled = true};
  const scene::Material wood = diffuseMaterial(vec3(0.5f)), glass = test::glassMaterial(vec3(1), 1.5f);
  const auto orderedOf = [](const scene::Material& first, const scene::Material& second) {
    SceneBuilder b;
    b.material(first).triangle({-4, -4, 3}, {4, -4, 3}, {0, 4, 3});
    b.material(second).triangle({-1, -1, 3}, {1, -1, 3}, {0, 1, 3}).triangle({7, 7, 3}, {9, 7, 3}, {9, 9, 3});
    return findCoincidences(b.scene).ordered;
  };
  const std::vector<bool> both{true, true, false}, none{false, false, false};
  CHECK(orderedOf(wood, wood) == none);
  CHECK(orderedOf(foil, foil) == none);
  CHECK(orderedOf(glass, glass) == both);  // one may be entered where the other is exited
  CHECK(orderedOf(wood, glass) == both);
  CHECK(orderedOf(foil, wood) == both);
  CHECK(orderedOf(glass, foil) == both);
  CHECK(orderedOf(diffuseMaterial(vec3(0), vec3(1)), foil) == std::vector<bool>{false, true, false});
}

TEST_CASE("parallel planes with a gap above the tolerance do not coincide") {
  for (const float coordinate : {1.0f, 10.0f, 1000.0f}) {
    SceneBuilder b = grey();
    const float above = coordinate + std::max(5.0f, coordinate) * 0x1p-19f;
    b.quad({-5, -5, coordinate}, {5, -5, coordinate}, {5, 5, coordinate}, {-5, 5, coordinate});
    b.quad({-4, -4, above}, {4, -4, above}, {4, 4, above}, {-4, 4, above});
    CAPTURE(coordinate);
    CHECK_FALSE(anyCoincide(findCoincidences(b.scene)));
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
    return anyCoincide(findCoincidences(b.scene));
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
  CHECK_FALSE(anyCoincide(findCoincidences(b.scene)));
}

TEST_CASE("neighbours in a flat mesh, in a closed box and at an acute edge do not coincide") {
  SceneBuilder b = grey();
  addGrid(b, 40, {0.1f, 0.2f, 0.3f}, {0.1f, 0.017f, 0.003f}, {-0.02f, 0.1f, 0.011f});
  b.box({5, 5, 5}, {6, 6, 6}).box({6, 5, 5.5f}, {7, 7, 8});
  b.quad({100, 0, 0}, {110, 0, 0}, {110, 10, 0}, {100, 10, 0});
  b.quad({100, 0, 0}, {110, 0, 0}, {110, 10, 0.5f}, {100, 10, 0.5f});
  const Coincidences found = findCoincidences(b.scene);
  CHECK(found.copies.size() == 0);
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
  CHECK(found.overlaps.empty());
  CHECK(std::count(found.coincident.begin(), found.coincident.end(), true) == 30000);
  CHECK_FALSE(found.coincident[30000]);
}

TEST_CASE("the search finds what a comparison of all pairs finds, on any number of threads") {
  const auto seed = GENERATE(1u, 2u, 3u, 4u);
  const SceneBuilder b = crowd(seed);
  const Coincidences found = findCoincidences(b.scene, 1);
  CAPTURE(seed);
  CHECK(found.overlaps.size() > 100);
  CHECK(found.copies.size() == 14);
  CHECK(found.overlaps == overlapsByBruteForce(b.scene, firstCopiesOf(b.scene)));
  const Coincidences again = findCoincidences(b.scene, 5);
  CHECK(again.copies == found.copies);
  CHECK(again.overlaps == found.overlaps);
  CHECK(again.coincident == found.coincident);
}

TEST_CASE("large meshes are compared in parts, which find every pair") {
  // The number of pairs of two grids is a polynomial of degree 2 of their side: pairs inside, at edges and at corners.
  const auto pairCount = [](int side, std::uint32_t threads) {
    SceneBuilder b = grey();
    addGrid(b, side, {0, 0, 1}, {0.1f, 0, 0}, {0, 0.1f, 0});
    addGrid(b, side, {0.04f, 0.03f, 1}, {0.1f, 0, 0}, {0, 0.1f, 0});
    addGrid(b, side, {0, 0, 1}, {0.1f, 0, 0}, {0, 0.1f, 0});
    const Coincidences found = findCoincidences(b.scene, threads);
    CHECK(found.copies.size() == std::size_t(2 * side * side));
    return static_cast<std::int64_t>(found.overlaps.size());
  };
  // Grids of the first three sides are within one part, that of the last one is not.
  const std::int64_t at10 = pairCount(10, 1), at20 = pairCount(20, 1), at30 = pairCount(30, 1);
  const std::int64_t expected = at10 + 9 * (at20 - at10) + 36 * (at30 - 2 * at20 + at10);
  CHECK(at10 > 400);
  CHECK(pairCount(100, 1) == expected);
  CHECK(pairCount(100, 4) == expected);
}

TEST_CASE("thousands of planes through a large mesh do not take long") {
  SceneBuilder b = grey();
  addGrid(b, 200, {0, 0, 0.5f}, {0.1f, 0, 0}, {0, 0.1f, 0.01f});
  for (int i = 0; i < 3000; ++i)
    b.plane({0, 0, 0.01f * static_cast<float>(i)}, {1, 0, 0.01f * static_cast<float>(i)},
            {0, 1, 0.01f * static_cast<float>(i)});
  b.quad({0, 0, 0.25f}, {1, 0, 0.25f}, {1, 1, 0.25f}, {0, 1, 0.25f});
  const Coincidences found = findCoincidences(b.scene);
  CHECK_FALSE(found.truncated);
  CHECK(found.overlaps == std::vector<Pair>{{80025, 83000}, {80025, 83001}});
}

TEST_CASE("a search that would compare too many planes ends and counts every plane") {
  SceneBuilder b = grey();
  for (int i = 0; i < 10000; ++i) {
    const float height = static_cast<float>(i);
    b.plane({0, 0, height}, {1, 0, height}, {0, 1, height});
  }
  const Coincidences found = findCoincidences(b.scene);
  CHECK(found.truncated);
  CHECK(std::count(found.coincident.begin(), found.coincident.end(), true) == 10000);
}
