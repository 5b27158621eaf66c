// Rounds affine maps to placements, and returns them as matrices.
#include "host/scene/placement.h"

#include <algorithm>
#include <cmath>

namespace candela::scene {
namespace {

double largestEntry(const glm::dmat3& m) {
  double largest = 0;
  for (glm::length_t column = 0; column < 3; ++column) {
    for (glm::length_t row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[column][row]));
  }
  return largest;
}

PlacementRows rowsOf(const glm::dmat3& linear, const glm::dvec3& translation) {
  PlacementRows rows;
  for (glm::length_t row = 0; row < 3; ++row) {
    rows[static_cast<std::size_t>(row)] = glm::vec4(
        glm::dvec4(linear[0][row], linear[1][row], linear[2][row], translation[row]));
  }
  return rows;
}

}  // namespace

glm::dmat3 linearPartOf(const Placement& placement) {
  const PlacementRows& rows = placement.points;
  return glm::transpose(glm::dmat3(glm::dvec3(rows[0]), glm::dvec3(rows[1]), glm::dvec3(rows[2])));
}

glm::dvec3 translationOf(const Placement& placement) {
  return {placement.points[0].w, placement.points[1].w, placement.points[2].w};
}

glm::mat3 inverseOf(const Placement& placement) {
  const glm::dmat3 linear = linearPartOf(placement);
  const glm::dmat3 cofactors = cofactorsOf(linear);
  return glm::mat3(glm::transpose(cofactors) / glm::dot(linear[0], cofactors[0]));
}

glm::dmat3 magnitudesOf(const glm::dmat3& m) { return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])}; }

glm::dmat3 cofactorsOf(const glm::dmat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

std::optional<Placement> placementOf(const glm::dmat4& map) {
  const glm::dmat3 linear(map);
  const glm::dmat3 cofactors = cofactorsOf(linear);
  const double determinant = glm::dot(linear[0], cofactors[0]);
  const double condition = 9 * largestEntry(linear) * largestEntry(cofactors) / std::abs(determinant);
  if (!(condition <= kMaxCondition)) return std::nullopt;
  const double scale = std::copysign(1 / largestEntry(cofactors), determinant);
  return Placement{rowsOf(linear, glm::dvec3(map[3])), rowsOf(scale * cofactors, glm::dvec3(0))};
}

}  // namespace candela::scene
