// The parts of generated glTF: textures that are stored as PNG, and closed, smooth surfaces of revolution.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "host/generate/lathe.h"
#include "host/generate/stored_png.h"
#include "host/image/image.h"

namespace candela::generate {

TEST_CASE("a stored PNG has the pixels that it was made of") {
  constexpr std::uint32_t kWidth = 257, kHeight = 131;  // more than one block of the stream
  std::vector<std::byte> rgb(std::size_t{3} * kWidth * kHeight);
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<std::byte>(i * i / 7);
  const auto file = std::filesystem::temp_directory_path() / "candela-stored.png";
  const std::vector<std::byte> png = storedPng(kWidth, kHeight, rgb);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  const image::Pixels8 pixels = image::readPixels8(file);
  std::filesystem::remove(file);
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

}  // namespace candela::generate
