// Meshes at random placements, some of which mirror.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <utility>

#include "host/formats/loading/scene_builder.h"
#include "host/scene/scene.h"

namespace candela::test {

/// Random numbers and maps, equal on all machines.
class RandomMaps {
 public:
  explicit RandomMaps(std::uint32_t seed) : random_(seed) {}

  double number(double low, double high) { return low + (high - low) * static_cast<double>(random_()) * 0x1p-32; }
  /// Each coordinate is between -size and size.
  glm::dvec3 point(double size) {
    const double x = number(-size, size), y = number(-size, size), z = number(-size, size);
    return {x, y, z};
  }
  /// Turns, shears, mirrors half of the time, and scales by a factor, the axes of which differ up to three times.
  glm::dmat4 next(double factor, const glm::dvec3& centre) {
    glm::dmat4 shear(1);
    shear[1][0] = number(-0.5, 0.5);
    shear[2][1] = number(-0.5, 0.5);
    const glm::dvec3 axis{number(-1, 1), number(-1, 1), number(0.1, 1)};
    const glm::dvec3 sizes{number(0.6, 1.8), number(0.6, 1.8), number(-1, 1) < 0 ? -1 : 1};
    return glm::translate(glm::dmat4(1), centre) * glm::rotate(glm::dmat4(1), number(0, 6), axis) * shear *
           glm::scale(glm::dmat4(1), factor * sizes);
  }

 private:
  std::mt19937 random_;
};

/// Returns a mesh for maps that mirror: with the opposite winding, and tangents of the opposite handedness.
inline scene::Mesh mirrored(scene::Mesh mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  for (glm::vec4& tangent : mesh.tangents) tangent.w = -tangent.w;
  return mesh;
}

/// Stores a mesh, and after it the one for maps that mirror. Returns the index of the first.
inline std::uint32_t storeBoth(scene::Scene& scene, const scene::Mesh& mesh) {
  const std::uint32_t first = storeMesh(scene, mesh);
  storeMesh(scene, mirrored(mesh));
  return first;
}

/// Shows a mesh, given by the result of storeBoth(), at a placement.
inline void addInstance(scene::Scene& scene, const glm::dmat4& map, std::uint32_t mesh, std::uint32_t material) {
  scene::addInstance(scene, mesh + (scene::mirrors(map) ? 1 : 0), scene::placementOf(map).value(), material);
}

}  // namespace candela::test
