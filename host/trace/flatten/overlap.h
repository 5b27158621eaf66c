// Overlap of convex polygons in a plane.
#pragma once
#include <glm/glm.hpp>
#include <span>

namespace candela::flatten {

/// Returns whether the interiors of two convex polygons overlap, seen along the coordinate axis that is closest to
/// `normal`. Polygons that only share an edge or a vertex do not.
bool overlap(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b, const glm::dvec3& normal);

}  // namespace candela::flatten
