// Makes the vertices of built-in shapes.
#include "host/formats/mitsuba/built_in_meshes.h"

#include <cmath>
#include <numbers>

namespace candela::mitsuba {
namespace {

constexpr int kSides = 256;

/// The cosine and the sine of a fraction of a turn; exact for quarters.
glm::dvec2 onCircle(double turns) {
  const double quarters = 4 * turns;
  if (quarters == std::floor(quarters)) {
    constexpr glm::dvec2 kQuarters[]{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return kQuarters[static_cast<int>(quarters) % 4];
  }
  const double angle = 2 * std::numbers::pi * turns;
  return {std::cos(angle), std::sin(angle)};
}

void addVertex(scene::Mesh& mesh, const glm::dvec3& position, const glm::dvec2& uv) {
  mesh.positions.emplace_back(position);
  mesh.texCoords[0].emplace_back(uv);
}

/// Adds two triangles for each patch of a grid of (columns + 1) by (rows + 1) vertices, with the fronts on the side
/// from which columns count counter-clockwise and rows upwards.
void addPatches(scene::Mesh& mesh, std::uint32_t columns, std::uint32_t rows) {
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t a = row * (columns + 1) + column, b = a + 1, c = a + columns + 1, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
  }
}

}  // namespace

scene::Mesh rectangleMesh() {
  scene::Mesh mesh;
  for (const glm::dvec2& corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
    addVertex(mesh, {corner, 0}, (corner + 1.0) / 2.0);
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

scene::Mesh cubeMesh() {
  scene::Mesh mesh;
  // By face: the corners with the texture coordinates (0, 1), (1, 1), (1, 0) and (0, 0), counter-clockwise.
  constexpr int kCorners[6][4]{{1, 5, 4, 0}, {3, 2, 6, 7}, {1, 3, 7, 5}, {5, 7, 6, 4}, {4, 6, 2, 0}, {3, 1, 0, 2}};
  constexpr glm::dvec2 kUv[4]{{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  for (int face = 0; face < 6; ++face) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int i = 0; i < 4; ++i) {
      const int corner = kCorners[face][i];
      addVertex(mesh, {corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1}, kUv[i]);
    }
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first + 3, first, first + 2});
  }
  return mesh;
}

scene::Mesh diskMesh() {
  const double angle = 2 * std::numbers::pi / kSides;
  const double radius = std::sqrt(angle / std::sin(angle));
  scene::Mesh mesh;
  for (int i = 0; i < kSides; ++i) {
    const double begin = static_cast<double>(i) / kSides, end = static_cast<double>(i + 1) / kSides;
    addVertex(mesh, glm::dvec3(0), {0, (begin + end) / 2});
    addVertex(mesh, {radius * onCircle(begin), 0}, {1, begin});
    addVertex(mesh, {radius * onCircle(end), 0}, {1, end});
    const auto first = static_cast<std::uint32_t>(3 * i);
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }
  return mesh;
}

scene::Mesh cylinderMesh() {
  scene::Mesh mesh;
  for (int row = 0; row <= 1; ++row) {
    for (int i = 0; i <= kSides; ++i) {
      const double turns = static_cast<double>(i) / kSides;
      const glm::dvec2 direction = onCircle(turns);
      mesh.normals.emplace_back(direction, 0);
      addVertex(mesh, {direction, row}, {turns, row});
    }
  }
  addPatches(mesh, kSides, 1);
  return mesh;
}

scene::Mesh sphereMesh() {
  constexpr int kRows = kSides / 2;
  scene::Mesh mesh;
  for (int row = 0; row <= kRows; ++row) {
    const glm::dvec2 meridian = onCircle(0.5 - static_cast<double>(row) / kSides);  // sine and cosine of the latitude
    for (int i = 0; i <= kSides; ++i) {
      const double turns = static_cast<double>(i) / kSides;
      const glm::dvec3 direction(meridian.y * onCircle(turns), meridian.x);
      mesh.normals.emplace_back(direction);
      addVertex(mesh, direction, {turns, 1 - static_cast<double>(row) / kRows});
    }
  }
  addPatches(mesh, kSides, kRows);
  return mesh;
}

}  // namespace candela::mitsuba
