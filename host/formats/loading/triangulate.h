// Splits a polygon, convex or concave, into triangles.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace candela::scene {

struct Triangulation {
  /// Indices into the polygon. Each triangle has the winding of the polygon. Their areas, projected along the polygon's
  /// normal, add up to the polygon's area. A vertex on a straight edge does not get a separate triangle.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool simple = true;         ///< false: edges cross; the triangles cover the same points, perhaps more than once
  double planeDeviation = 0;  ///< maximum distance of a vertex from the polygon's plane, as a fraction of its extent
};

/// Clips ears in the coordinate plane to which the polygon is most nearly parallel. Coordinates there are exact, and
/// orientations are computed in double precision. At least 3 vertices; quadratic time in the worst case. A polygon
/// without area gives a fan of triangles that are never hit. Holes may be connected by a pair of coincident edges.
Triangulation triangulate(std::span<const glm::vec3> polygon);

}  // namespace candela::scene
