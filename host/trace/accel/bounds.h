// Axis-aligned bounding boxes in single precision.
#pragma once
#include <algorithm>
#include <cstddef>
#include <glm/glm.hpp>
#include <limits>

namespace candela::accel {

/// The box of all points p with min <= p <= max on each axis. A new box is empty: min is above max.
struct Aabb {
  glm::vec3 min{std::numeric_limits<float>::infinity()};
  glm::vec3 max{-std::numeric_limits<float>::infinity()};

  bool isEmpty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }

  void extend(const glm::vec3& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
  void extend(const Aabb& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }

  bool contains(const Aabb& other) const {
    return glm::all(glm::lessThanEqual(min, other.min)) && glm::all(glm::greaterThanEqual(max, other.max));
  }

  glm::dvec3 extent() const { return isEmpty() ? glm::dvec3(0) : glm::dvec3(max) - glm::dvec3(min); }
  /// Computed in double precision, so that no finite box overflows; 0 if empty.
  double surfaceArea() const {
    const glm::dvec3 e = extent();
    return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
  }

  bool operator==(const Aabb&) const = default;
};

/// Returns the largest float that is not above `x`.
float roundDown(double x);

/// Checks a box for builders: finite, not empty, within +-2^100. Throws InternalError, which names box `index` of
/// `structure`.
void requireProper(const Aabb& box, std::size_t index, const char* structure);

}  // namespace candela::accel
