// Splits a polygon, concave or not, into triangles.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace candela::scene {

struct Triangulation {
  /// Indices into the polygon, each triangle turning as the polygon does. Their areas, seen along the polygon's normal,
  /// sum to the polygon's. Vertices on a straight edge get no triangle of their own.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool simple = true;         ///< false: edges cross; the triangles then cover the same points, perhaps more than once
  double planeDeviation = 0;  ///< largest distance of a vertex from the polygon's plane, as a share of its extent
};

/// Ear clipping in the coordinate plane that the polygon faces most, where binary32 coordinates are exact, with
/// orientations in double precision. At least 3 vertices; quadratic time at worst. A polygon without area gives a fan,
/// whose triangles are never hit. Holes may be bridged by an edge to and fro.
Triangulation triangulate(std::span<const glm::vec3> polygon);

}  // namespace candela::scene
