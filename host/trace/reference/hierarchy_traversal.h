// The traversal of a BVH by a ray, in the space of the scene or of a mesh.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "host/trace/reference/hierarchy.h"

namespace candela::reference {

/// A ray for tests of boxes. Its direction has any length.
struct BoxRay {
  dvec3 origin;
  dvec3 direction;
  double padding = 0;  ///< boxes are tested as if they were larger by this on each side
};

/// Returns the reciprocals, finite where the direction is 0.
inline dvec3 inverseOf(const dvec3& direction) {
  dvec3 inverse;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = direction[axis];
    inverse[axis] = std::abs(d) > 1e-300 ? 1 / d : std::copysign(1e300, d);  // so that 0 times it is 0
  }
  return inverse;
}

/// Calls visit(i) for the positions i in Hierarchy::order of the leaves that a ray enters before the distance `limit`,
/// in units of the direction's length, which `visit` may reduce. Ends when `visit` returns true, and returns whether it
/// did. Adds nodes and calls to `steps`. The hierarchy must not be empty.
template <class Visit>
bool traverse(const Hierarchy& hierarchy, const BoxRay& ray, const double& limit, std::uint64_t& steps, Visit&& visit) {
  const dvec3 inverse = inverseOf(ray.direction);
  const dvec3 fromMin = ray.origin + ray.padding;
  const dvec3 fromMax = ray.origin - ray.padding;
  // This is the only call, so that compilers inline it: most of the time of a traversal is spent here.
  const auto enters = [&](const Bounds& box) {
    constexpr double kSlack = 1 + 1e-12;  // distances of a hit and of its box may have errors of opposite sign
    const dvec3 a = (box.min - fromMin) * inverse;
    const dvec3 b = (box.max - fromMax) * inverse;
    const dvec3 low = glm::min(a, b);
    const dvec3 high = glm::max(a, b);
    const double entry = std::max(std::max(low.x, low.y), std::max(low.z, 0.0));
    const double exit = std::min(std::min(high.x, high.y), high.z);
    return entry <= exit * kSlack && entry <= limit * kSlack;
  };
  std::array<std::uint32_t, Hierarchy::kMaxDepth + 1> stack;
  std::uint32_t stackSize = 0;
  stack[stackSize++] = 0;
  while (stackSize > 0) {
    const std::uint32_t index = stack[--stackSize];
    const Node& node = hierarchy.nodes[index];
    ++steps;
    if (!enters(node.bounds)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      ++steps;
      if (visit(i)) return true;
    }
    if (node.count > 0) continue;
    const bool forward = ray.direction[node.axis] >= 0;
    stack[stackSize++] = forward ? node.first : index + 1;
    stack[stackSize++] = forward ? index + 1 : node.first;
  }
  return false;
}

}  // namespace candela::reference
