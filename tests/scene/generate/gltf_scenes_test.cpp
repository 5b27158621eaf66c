// The parts of generated glTF: textures that are stored as PNG, and closed, smooth surfaces of revolution.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>

#include "host/image/image.h"
#include "host/scene/generate/lathe.h"
#include "host/scene/generate/stored_png.h"
#include "tests/base/temporary_folder.h"
#include "tests/formats/loading/triangles.h"
#include "tests/image/read_pixels8.h"
#include "tests/scene/generate/generated_text.h"

namespace candela::generate {

TEST_CASE("a stored PNG has the pixels that it was made of") {
  constexpr std::uint32_t kWidth = 257, kHeight = 131;  // more than one block of the stream
  std::vector<std::byte> rgb(std::size_t{3} * kWidth * kHeight);
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<std::byte>(i * i / 7);
  const TemporaryFolder folder;
  const auto file = folder / "stored.png";
  const std::vector<std::byte> png = storedPng(kWidth, kHeight, rgb);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  const image::Pixels8 pixels = image::readPixels8(file);
  REQUIRE(pixels.width == kWidth);
  REQUIRE(pixels.height == kHeight);
  CHECK(std::equal(rgb.begin(), rgb.end(), reinterpret_cast<const std::byte*>(pixels.rgb.data())));
}

TEST_CASE("a turned sphere encloses its volume, and its normals point away from the centre") {
  const TriangleMesh mesh = lathe(sphereProfile(2, 64), 128);
  CHECK(mesh.indices.size() == 3 * latheTriangles(sphereProfile(2, 64), 128));
  double volume = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
        c(mesh.positions[mesh.indices[i + 2]]);
    volume += dot(a, cross(b, c)) / 6;
  }
  CHECK(volume == Approx(4.0 / 3 * 3.14159265 * 8).epsilon(3e-3));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    REQUIRE(length(mesh.normals[i]) == Approx(1));
    REQUIRE(dot(mesh.normals[i], mesh.positions[i]) / 2 == Approx(1).epsilon(1e-2));
  }
}

TEST_CASE("a profile that turns sharply has an edge there") {
  const TriangleMesh cylinder = lathe({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 8);
  for (const glm::vec3& normal : cylinder.normals) {
    const bool isFlat = std::abs(normal.y) > 0.999f, isAround = std::abs(normal.y) < 1e-3f;
    CHECK((isFlat || isAround));
  }
}

TEST_CASE("brilliants are closed and convex, with plane facets") {
  for (const std::uint32_t size : {6u, 8u, 31u}) {
    const scene::LoadedScene loaded = generatedScene("brilliants", size);
    std::vector<scene::Triangle> stone = trianglesOf(loaded.scene);
    stone.resize(14 * size - 2);
    const auto key = [](const glm::vec3& v) { return std::array{v.x, v.y, v.z}; };
    std::map<std::array<std::array<float, 3>, 2>, int> edges;  // how often in this direction minus in the other
    double volume = 0;
    for (const scene::Triangle& t : stone) {
      const glm::dvec3 a(t.p[0]), b(t.p[1]), c(t.p[2]), normal = normalize(cross(b - a, c - a));
      volume += dot(a, cross(b, c)) / 6;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto from = key(t.p[k]), to = key(t.p[(k + 1) % 3]);
        edges[from < to ? std::array{from, to} : std::array{to, from}] += from < to ? 1 : -1;
        for (const scene::Triangle& other : stone) {
          CHECK(dot(normal, glm::dvec3(other.p[k]) - a) < 1e-5);
          CHECK(other.p[k].y > 0);
        }
      }
    }
    CHECK(std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; }));
    CHECK(edges.size() == 3 * stone.size() / 2);
    CHECK(volume == Approx(1.677).epsilon(5e-3));
  }
}

TEST_CASE("the three brilliants disperse by 0, 0.36 and 2.04") {
  const scene::LoadedScene loaded = generatedScene("brilliants", 8);
  for (std::size_t i = 0; i < 3; ++i) {
    const scene::SurfaceParameters& stone = *loaded.scene.materials[i].surface;
    CHECK(stone.ior == 2.417f);
    CHECK(stone.transmissionDispersionScale == std::array{0.0f, 0.36f, 2.04f}[i]);
    CHECK(stone.disperses() == (i > 0));
  }
}

}  // namespace candela::generate
