// Texture coordinates, tangents and colours of a mesh, interpolated over a triangle.
#pragma once
#include <array>

#include "host/scene/scene.h"
#include "host/trace/reference/ray.h"

namespace candela::reference {

/// The attributes at a point of a mesh's triangle. They are 0 if the mesh does not have them, and for other primitives.
struct MeshAttributes {
  std::array<glm::dvec2, 2> texCoords{};
  std::array<glm::dvec2, 2> texCoordScale{};  ///< largest magnitudes at the vertices
  dvec3 tangent{0};                           ///< unit vector along which the texture's first coordinate increases
  dvec3 bitangent{0};                         ///< the vertices' handedness times cross(normal, tangent)
  glm::dvec4 colour{0};
};

/// Returns the weighted mean of the values at the three vertices, with weights 1 - b.x - b.y, b.x and b.y.
template <class Double, class Single>
Double interpolate(const std::array<Single, 3>& values, const glm::dvec2& b) {
  return (1 - b.x - b.y) * Double(values[0]) + b.x * Double(values[1]) + b.y * Double(values[2]);
}

/// Returns the attributes at barycentric coordinates (b1, b2) of a primitive that is a triangle. `normal` is the unit
/// normal of the tangent frame, on the side of the outward geometric normal.
MeshAttributes attributesAt(const scene::Scene& scene, const scene::Primitive& triangle, const glm::dvec2& b,
                            const dvec3& normal);

}  // namespace candela::reference
