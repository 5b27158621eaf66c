// Normal maps, and meshes that can have them.
#pragma once
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "host/formats/loading/mikk_tangents.h"
#include "host/scene/scene.h"

namespace candela::test {

/// Random normals, up to 80 degrees from the surface.
inline scene::TextureImage bumps(std::uint32_t side) {
  std::mt19937 random(5);
  scene::TextureImage image{"bumps", side, side, {}};
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const auto word = static_cast<std::uint32_t>(random());
    image.texels.push_back((word & 0xffffu) | (150 + (word >> 16) % 106) << 16 | 0xff000000u);
  }
  return image;
}

inline scene::TextureImage oneTexel(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return {"texel", 1, 1, {red | green << 8 | blue << 16 | 0xff000000u}};
}

inline scene::Material mapped(const scene::SurfaceParameters& surface) {
  scene::Material material;
  material.surface = surface;
  material.textures[static_cast<std::size_t>(scene::TextureSlot::normal)].emplace();
  return material;
}

inline scene::Mesh withTangents(scene::Mesh mesh) {
  const std::vector<glm::vec4> corners = scene::mikkTangents(mesh, {});
  mesh.tangents.resize(mesh.positions.size());
  for (std::size_t i = 0; i < corners.size(); ++i) mesh.tangents[mesh.indices[i]] = corners[i];
  return mesh;
}

/// A square around the origin in the plane z = 0, whose tangents point along x.
inline scene::Mesh flatSquare(float halfSide) {
  scene::Mesh mesh;
  mesh.positions = {
      {-halfSide, -halfSide, 0}, {halfSide, -halfSide, 0}, {halfSide, halfSide, 0}, {-halfSide, halfSide, 0}};
  mesh.texCoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return withTangents(mesh);
}

/// A ball of few triangles with smooth normals, so that geometric and shading normals differ. The image is repeated
/// `turns` times around it, mirrored if this is negative.
inline scene::Mesh ball(const glm::vec3& centre, float radius, float turns) {
  constexpr std::uint32_t kColumns = 12, kRows = 6;
  constexpr float kHalfTurn = 3.14159265f;
  scene::Mesh mesh;
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    for (std::uint32_t column = 0; column <= kColumns; ++column) {
      const float u = static_cast<float>(column) / kColumns;
      const float v = static_cast<float>(row) / kRows;
      const glm::vec3 n(std::sin(kHalfTurn * v) * std::cos(2 * kHalfTurn * u),
                        std::sin(kHalfTurn * v) * std::sin(2 * kHalfTurn * u), std::cos(kHalfTurn * v));
      mesh.positions.push_back(centre + radius * n);
      mesh.normals.push_back(n);
      mesh.texCoords[0].emplace_back(turns * u, 2 * v);
      if (row == kRows || column == kColumns) continue;
      const std::uint32_t at = row * (kColumns + 1) + column;
      const std::uint32_t below = at + kColumns + 1;
      mesh.indices.insert(mesh.indices.end(), {at, below, below + 1, at, below + 1, at + 1});
    }
  }
  return withTangents(mesh);
}

}  // namespace candela::test
