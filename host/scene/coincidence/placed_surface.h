// Surfaces of a mesh that may coincide once a placement has rounded their vertices.
#pragma once
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>

#include "host/scene/mesh.h"
#include "host/scene/placement.h"

namespace candela::scene {

/// How much two surfaces of a mesh may be apart, in the space of the mesh, and coincide where the mesh is placed.
struct PlacedTolerance {
  double plane = 0;   ///< maximum of the tolerance e of overlapInPlane()
  double vertex = 0;  ///< maximum distance by which rounding moves a vertex
  double condition = 1;
  double minPlane = INFINITY;  ///< minimum of e
  double maxMoved = 0;  ///< maximum of the distance by which rounding moves a vertex of an instance, relative to e

  void include(const PlacedTolerance& other);
};

/// Returns the tolerance of a placement for a mesh in this box.
PlacedTolerance toleranceOf(const Placement& placement, const glm::vec3& low, const glm::vec3& high);

/// Places boxes of a mesh.
class BoxPlacement {
 public:
  explicit BoxPlacement(const Placement& placement);

  /// Replaces a box in the space of the mesh by the box around what the instance shows of it, padded by the tolerance.
  void operator()(glm::vec3& low, glm::vec3& high) const;

 private:
  glm::dmat3 linear_, magnitudes_;
  glm::dvec3 translation_;
};

/// A triangle in the space of its mesh. Has no initial values.
struct MeshTriangle {
  std::array<glm::vec3, 3> corners;
  glm::dvec3 normal;  ///< unit, if the triangle has an area
  double altitude;    ///< the shortest one
};

/// Returns nothing if two vertices are equal: the triangle has no area in any instance.
std::optional<MeshTriangle> meshTriangleOf(const Triangle& triangle);

/// Returns false only if two triangles of a mesh are neither copies nor overlap in one plane in any instance: see
/// overlapInPlane(). `tolerance` must include those of all placements.
bool mayCoincide(const MeshTriangle& a, const MeshTriangle& b, const PlacedTolerance& tolerance);

}  // namespace candela::scene
