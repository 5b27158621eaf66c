// Searches for a line between two convex polygons along one of their edges (separating axis theorem).
#include "host/trace/flatten/overlap.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace candela::flatten {
namespace {

using glm::dvec2;
using glm::dvec3;

std::vector<dvec2> projected(std::span<const dvec3> polygon, const dvec3& normal) {
  const dvec3 size = glm::abs(normal);
  const int dropped = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  std::vector<dvec2> result;
  for (const dvec3& p : polygon) result.emplace_back(p[(dropped + 1) % 3], p[(dropped + 2) % 3]);
  return result;
}

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Interval along(const dvec2& axis, const std::vector<dvec2>& polygon) {
  Interval result;
  for (const dvec2& p : polygon) {
    result.low = std::min(result.low, dot(axis, p));
    result.high = std::max(result.high, dot(axis, p));
  }
  return result;
}

// Returns whether a line along an edge of `a` separates the polygons. They may touch within the rounding of double
// precision.
bool separates(const std::vector<dvec2>& a, const std::vector<dvec2>& b) {
  constexpr double kRounding = 1e-12;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const dvec2 edge = a[(i + 1) % a.size()] - a[i];
    const dvec2 across(-edge.y, edge.x);
    const Interval ofA = along(across, a);
    const Interval ofB = along(across, b);
    const double size = std::max({std::abs(ofA.low), std::abs(ofA.high), std::abs(ofB.low), std::abs(ofB.high)});
    if (std::min(ofA.high - ofB.low, ofB.high - ofA.low) <= kRounding * size) return true;
  }
  return false;
}

}  // namespace

bool overlap(std::span<const dvec3> a, std::span<const dvec3> b, const dvec3& normal) {
  const std::vector<dvec2> flatA = projected(a, normal);
  const std::vector<dvec2> flatB = projected(b, normal);
  return !separates(flatA, flatB) && !separates(flatB, flatA);
}

}  // namespace candela::flatten
