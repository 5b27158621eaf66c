// Writes six grids of vertices, then their triangles.
#include "host/scene/generate/cube_sphere.h"

#include <array>

namespace candela::generate {
namespace {

constexpr std::array<CubeFace, 6> kCubeFaces{{{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}}};

/// Returns the direction to a point of a face's grid of size x size cells.
glm::dvec3 directionTo(const CubeFace& face, std::uint32_t i, std::uint32_t j, std::uint32_t size) {
  glm::dvec3 onCube;
  onCube[face.normal] = face.side;
  onCube[face.u()] = -1 + 2.0 * i / size;
  onCube[face.v()] = -1 + 2.0 * j / size;
  return glm::normalize(onCube);
}

void writeTriangles(NffWriter& out, std::uint32_t size) {
  const std::uint64_t row = size + 1;
  std::uint64_t first = 1;
  for (const CubeFace& face : kCubeFaces) {
    for (std::uint64_t j = 0; j < size; ++j) {
      for (std::uint64_t i = 0; i < size; ++i) {
        const std::uint64_t corner = first + j * row + i;
        // On the negative side, u and v are clockwise seen from outside.
        const std::uint64_t next = face.side > 0 ? corner + 1 : corner + row;
        const std::uint64_t previous = face.side > 0 ? corner + row : corner + 1;
        out.meshFace(corner, next, corner + row + 1);
        out.meshFace(corner + row + 1, previous, corner);
      }
    }
    first += row * row;
  }
}

}  // namespace

void writeCubeSphere(NffWriter& out, std::uint32_t size,
                     const std::function<glm::dvec3(const glm::dvec3& direction)>& place) {
  const std::uint64_t verticesOfFace = (std::uint64_t{size} + 1) * (size + 1);
  out.mesh(kCubeFaces.size() * verticesOfFace, kCubeFaces.size() * 2 * size * size);
  for (const CubeFace& face : kCubeFaces) {
    for (std::uint32_t j = 0; j <= size; ++j) {
      for (std::uint32_t i = 0; i <= size; ++i) out.meshVertex(place(directionTo(face, i, j, size)));
    }
  }
  writeTriangles(out, size);
}

}  // namespace candela::generate
