// Visits the primitives that a ray may hit: all of them, or those that the BVH or the grid leads to.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "host/trace/reference/tracing.h"

namespace candela::reference {

/// Returns the reciprocals, finite where the direction is 0.
inline dvec3 inverseOf(const dvec3& direction) {
  dvec3 inverse;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = direction[axis];
    inverse[axis] = std::abs(d) > 1e-300 ? 1 / d : std::copysign(1e300, d);  // so that 0 times it is 0
  }
  return inverse;
}

/// Returns whether a ray, of whose direction `inverse` has the reciprocals, enters the box before `limit`.
inline bool intersects(const Bounds& box, const dvec3& origin, const dvec3& inverse, double limit) {
  constexpr double kSlack = 1 + 1e-12;  // distances of a hit and of its box may have errors of opposite sign
  const dvec3 a = (box.min - origin) * inverse;
  const dvec3 b = (box.max - origin) * inverse;
  const dvec3 low = glm::min(a, b);
  const dvec3 high = glm::max(a, b);
  const double entry = std::max(std::max(low.x, low.y), std::max(low.z, 0.0));
  const double exit = std::min(std::min(high.x, high.y), high.z);
  return entry <= exit * kSlack && entry <= limit * kSlack;
}

template <class Visit>
void Tracing::visitItems(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const {
  if (hasHierarchy() && visitHierarchy(ray, limit, counters, visit)) return;
  const bool throughGrid = hasGrid() && grid_.serves(ray.origin);
  if (throughGrid && visitGrid(ray, limit, counters, visit)) return;
  for (std::size_t i = hasGrid() && !throughGrid ? 0 : firstOutside_; i < items_.size(); ++i) {
    ++counters.traversalSteps;
    if (visit(items_[i])) return;
  }
}

template <class Visit>
bool Tracing::visitHierarchy(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const {
  const dvec3 inverse = inverseOf(ray.direction);
  std::array<std::uint32_t, Hierarchy::kMaxDepth + 1> stack;
  std::uint32_t stackSize = 0;
  stack[stackSize++] = 0;
  while (stackSize > 0) {
    const std::uint32_t index = stack[--stackSize];
    const Node& node = hierarchy_.nodes[index];
    ++counters.traversalSteps;
    if (!intersects(node.bounds, ray.origin, inverse, limit)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      ++counters.traversalSteps;
      if (visit(items_[i])) return true;
    }
    if (node.count > 0) continue;
    const bool forward = ray.direction[node.axis] >= 0;
    stack[stackSize++] = forward ? node.first : index + 1;
    stack[stackSize++] = forward ? index + 1 : node.first;
  }
  return false;
}

// A hit within a cell belongs to an item of the cell. Therefore the closest hit is final once it is before the exit
// from the cell.
template <class Visit>
bool Tracing::visitGrid(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const {
  for (GridTraversal traversal(grid_, ray); traversal.isInside(); traversal.advance()) {
    ++counters.traversalSteps;
    for (const std::uint32_t item : grid_.itemsOf(traversal.cell())) {
      ++counters.traversalSteps;
      if (visit(items_[item])) return true;
    }
    if (limit < traversal.exit()) return false;
  }
  return false;
}

}  // namespace candela::reference
