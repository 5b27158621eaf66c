// Every kind has exactly the number of primitives of its definition, as counted by the loader.
#include <catch2/catch.hpp>

#include "tests/formats/loading/triangles.h"
#include "tests/scene/generate/generated_text.h"

namespace candela {
namespace {

/// Counts that the file should have, by the statements of the loader's report.
struct Expectation {
  std::size_t spheres = 0;
  std::size_t cones = 0;
  std::size_t polygons = 0;
  std::size_t patches = 0;
  std::size_t triangles = 0;  ///< as traced
};

std::size_t statements(const scene::LoadedScene& loaded, const std::string& kind) {
  const auto found = loaded.counts.find(kind);
  return found == loaded.counts.end() ? 0 : found->second;
}

void check(const std::string& kind, std::uint32_t size, const Expectation& expected) {
  CAPTURE(kind, size);
  const scene::LoadedScene loaded = generatedScene(kind, size);
  CHECK(loaded.scene.spheres.size() == expected.spheres);
  CHECK(loaded.scene.cones.size() == expected.cones);
  CHECK(statements(loaded, "polygon") == expected.polygons);
  CHECK(statements(loaded, "patch") == expected.patches);
  CHECK(trianglesOf(loaded.scene).size() == expected.triangles);
  CHECK(loaded.scene.primitives.size() == kindNamed(kind).primitiveCount(size));
}

std::size_t power(std::size_t base, std::size_t exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

}  // namespace

TEST_CASE("the scene balls has the sum of 9^i spheres and a square") {
  check("balls", 1, {.spheres = 10, .polygons = 1, .triangles = 2});
  check("balls", 3, {.spheres = 820, .polygons = 1, .triangles = 2});
  check("balls", 4, {.spheres = 7381, .polygons = 1, .triangles = 2});
  CHECK(kindNamed("balls").primitiveCount(5) == 66430 + 2);
  CHECK(kindNamed("balls").primitiveCount(6) == 597871 + 2);
}

TEST_CASE("the scene mount has 2 4^s triangles and four spheres") {
  for (std::uint32_t s = 1; s <= 6; ++s) {
    check("mount", s, {.spheres = 4, .polygons = 2 * power(4, s), .triangles = 2 * power(4, s)});
  }
}

TEST_CASE("the scene tetra has 4^s triangles") {
  for (std::uint32_t s = 1; s <= 6; ++s) check("tetra", s, {.polygons = power(4, s), .triangles = power(4, s)});
}

TEST_CASE("the scene rings has 5 s (s+1) (2s+1) spheres, as many cylinders and a wall") {
  for (const std::size_t s : {1, 2, 3, 7}) {
    const std::size_t count = 5 * s * (s + 1) * (2 * s + 1);
    check("rings", static_cast<std::uint32_t>(s), {.spheres = count, .cones = count, .polygons = 1, .triangles = 2});
  }
}

TEST_CASE("the scene gears has s^3 gears of two 144-gons and 144 quads, and a square") {
  for (const std::size_t s : {1, 2, 4}) {
    const std::size_t gears = s * s * s;
    check("gears", static_cast<std::uint32_t>(s),
          {.polygons = 1 + gears * 146, .triangles = 2 + gears * (2 * 142 + 144 * 2)});
  }
}

TEST_CASE("the scene tree has 2^(s+1) - 1 cones and spheres, and a square") {
  for (const std::uint32_t s : {1u, 2u, 5u, 11u}) {
    const std::size_t branches = power(2, s + 1) - 1;
    check("tree", s, {.spheres = branches, .cones = branches, .polygons = 1, .triangles = 2});
  }
}

TEST_CASE("the scene jacks has the sum of 8^i jacks of three cylinders and six spheres") {
  check("jacks", 1, {.spheres = 6, .cones = 3});
  check("jacks", 2, {.spheres = 6 * 9, .cones = 3 * 9});
  check("jacks", 4, {.spheres = 6 * 585, .cones = 3 * 585});
}

TEST_CASE("the scene lattice has (s+1)^3 spheres and 3 s (s+1)^2 cylinders") {
  for (const std::size_t s : {1, 2, 3, 12}) {
    check("lattice", static_cast<std::uint32_t>(s), {.spheres = power(s + 1, 3), .cones = 3 * s * power(s + 1, 2)});
  }
}

TEST_CASE("the scene shells has 180 2^s spheres and one more") {
  for (std::uint32_t s = 1; s <= 5; ++s) check("shells", s, {.spheres = 180 * power(2, s) + 1});
}

TEST_CASE("the scene sombrero has two triangles for each cell between 16 2^s points per side") {
  for (const std::uint32_t s : {1u, 2u, 3u}) {
    const std::size_t triangles = 2 * power(16 * power(2, s) - 1, 2);
    check("sombrero", s, {.polygons = triangles, .triangles = triangles});
  }
}

TEST_CASE("the scene teapot has 64 n^2 - 8 n patches and n^2 squares") {
  for (const std::size_t n : {1, 2, 3, 6, 12}) {
    const std::size_t patches = 64 * n * n - 8 * n;
    check("teapot", static_cast<std::uint32_t>(n),
          {.polygons = n * n, .patches = patches, .triangles = patches + 2 * n * n});
  }
}

TEST_CASE("the scene terrain has 2 (n-1)^2 triangles of one mesh") {
  for (const std::size_t n : {2, 3, 100}) {
    check("terrain", static_cast<std::uint32_t>(n), {.triangles = 2 * (n - 1) * (n - 1)});
  }
  CHECK(kindNamed("terrain").primitiveCount(708) == 999698);
}

TEST_CASE("the scene sphere has 12 n^2 triangles of one mesh, in a room of 18 triangles with a light of two") {
  for (const std::size_t n : {1, 2, 76}) {
    check("sphere", static_cast<std::uint32_t>(n), {.polygons = 9, .triangles = 12 * n * n + 20});
  }
}

TEST_CASE("the scene cornell has two meshes of 12 n^2 triangles, in a box of 16 triangles with a light of two") {
  for (const std::size_t n : {1, 2, 29}) {
    check("cornell", static_cast<std::uint32_t>(n), {.polygons = 8, .triangles = 2 * 12 * n * n + 18});
  }
}

}  // namespace candela
