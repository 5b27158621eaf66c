// Flat parts of primitives, and whether two of them overlap in one plane.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "host/scene/coincidence/box_tree.h"
#include "host/scene/shape.h"

namespace candela::scene {

/// A triangle, a face of a box or a plane. Has no initial values.
struct FlatSurface {
  std::array<glm::vec3, 4> corners;  ///< of a plane, the first is one of its points
  std::uint32_t cornerCount;         ///< 0: infinite
  std::uint32_t primitive;
  float reach;        ///< magnitude of the largest coordinate
  glm::dvec3 normal;  ///< unit

  bool isFinite() const { return cornerCount > 0; }
  std::span<const glm::vec3> polygon() const { return std::span(corners).first(cornerCount); }
};

/// Returns the magnitude of the largest coordinate of points.
float reachOf(std::span<const glm::vec3> points);

/// Returns the number of flat parts of a primitive.
std::size_t flatPartCount(PrimitiveKind kind);

/// Stores the flat parts of a shape in `parts`, which has flatPartCount() elements. Returns the number of those that
/// have an area; the elements after these are not changed.
std::size_t storeFlatParts(const Shape& shape, std::uint32_t primitive, std::span<FlatSurface> parts);

/// Returns the box of a finite surface, padded by the tolerance. The item is `index`.
ItemBox boxOf(const FlatSurface& surface, std::uint32_t index);

/// Returns whether a finite surface that is in this box, as boxOf() returns it, may lie in a plane.
bool mayLieIn(const FlatSurface& plane, const glm::vec3& low, const glm::vec3& high);

/// Returns whether two flat surfaces lie in one plane and, if both are finite, overlap by more than the tolerance:
/// coincidence.h. The order matters only for rounding.
bool overlapInPlane(const FlatSurface& a, const FlatSurface& b);

}  // namespace candela::scene
