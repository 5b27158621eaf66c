// Closed meshes around a point, for rays that must not escape.
#pragma once
#include <cmath>
#include <numbers>

#include "tests/trace/reference/scene_builder.h"

namespace candela::proof {

/// Triangles with shared vertices. A ray from the centre hits exactly one.
struct ClosedMesh {
  std::vector<glm::vec3> vertices;
  std::vector<glm::uvec3> faces;
  glm::vec3 middle{0};

  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    faces.push_back({a, b, c});
    faces.push_back({a, c, d});
  }
  /// Vertices are rounded again, and neighbours still share them.
  ClosedMesh movedTo(const glm::vec3& place) const {
    ClosedMesh moved = *this;
    for (glm::vec3& vertex : moved.vertices) vertex += place;
    moved.middle = place;
    return moved;
  }
  scene::Scene scene() const {
    test::SceneBuilder b;
    b.material(test::diffuseMaterial(glm::vec3(0.5f)));
    for (const glm::uvec3& f : faces) b.triangle(vertices[f.x], vertices[f.y], vertices[f.z]);
    return b.scene;
  }
};

/// By meridians and parallels. Few parallels make needles: triangles from pole to equator, hundreds of times as long as
/// wide.
inline ClosedMesh sphereMesh(float radius, std::uint32_t meridians, std::uint32_t parallels) {
  ClosedMesh mesh;
  mesh.vertices.push_back({0, 0, radius});
  for (std::uint32_t row = 1; row <= parallels; ++row) {
    const double theta = std::numbers::pi * row / (parallels + 1);
    for (std::uint32_t column = 0; column < meridians; ++column) {
      const double phi = 2 * std::numbers::pi * column / meridians;
      const glm::dvec3 unit(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      mesh.vertices.push_back(glm::vec3(double{radius} * unit));
    }
  }
  mesh.vertices.push_back({0, 0, -radius});
  const auto at = [&](std::uint32_t row, std::uint32_t column) { return 1 + row * meridians + column % meridians; };
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (std::uint32_t column = 0; column < meridians; ++column) {
    mesh.faces.push_back({0, at(0, column), at(0, column + 1)});
    mesh.faces.push_back({last, at(parallels - 1, column + 1), at(parallels - 1, column)});
    for (std::uint32_t row = 0; row + 1 < parallels; ++row) {
      mesh.quad(at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1));
    }
  }
  return mesh;
}

/// A cube of half side `half`, each face cut into `cuts` by `cuts` squares of two triangles, all in one plane.
inline ClosedMesh boxMesh(float half, std::uint32_t cuts) {
  ClosedMesh mesh;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto coordinate = [&](std::uint32_t i) {
      return half * (2 * static_cast<float>(i) / static_cast<float>(cuts) - 1);
    };
    for (std::uint32_t row = 0; row <= cuts; ++row) {
      for (std::uint32_t column = 0; column <= cuts; ++column) {
        glm::vec3 vertex;
        vertex[axis] = face % 2 == 0 ? half : -half;
        vertex[(axis + 1) % 3] = coordinate(column);
        vertex[(axis + 2) % 3] = coordinate(row);
        mesh.vertices.push_back(vertex);
      }
    }
    const auto at = [&](std::uint32_t row, std::uint32_t column) { return first + row * (cuts + 1) + column; };
    for (std::uint32_t row = 0; row < cuts; ++row) {
      for (std::uint32_t column = 0; column < cuts; ++column) {
        mesh.quad(at(row, column), at(row, column + 1), at(row + 1, column + 1), at(row + 1, column));
      }
    }
  }
  return mesh;
}

}  // namespace candela::proof
