// Rotations in space.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace candela::generate {

inline constexpr double kTurn = 2 * std::numbers::pi;  ///< in radians

/// Returns a counter-clockwise rotation, seen against `axis`, which need not have unit length.
inline glm::dmat3 rotation(double radians, const glm::dvec3& axis) {
  return glm::dmat3(glm::rotate(glm::dmat4(1), radians, axis));
}

}  // namespace candela::generate
