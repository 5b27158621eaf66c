// balls: the sphereflake. Each ball has nine children with a third of its radius that touch it, six around its equator
// and three on its far side.
#include <array>
#include <cmath>
#include <numbers>

#include "host/scene/generate/databases.h"
#include "host/scene/generate/rotation.h"

namespace candela::generate {
namespace {

constexpr double kRatio = 1.0 / 3.0;  ///< ratio of a child's radius to its parent's

using Directions = std::array<glm::dvec3, 9>;

/// Directions to the children of a ball whose own parent is below it: the midpoints of three edges of a cube, tilted
/// until their mean points up, and their rotations by thirds of a turn.
Directions childDirections() {
  const double half = 1 / std::sqrt(2.0);
  const std::array<glm::dvec3, 3> trio{{{half, half, 0}, {half, 0, -half}, {0, half, -half}}};
  const glm::dmat3 tilt = rotation(std::asin(2 / std::sqrt(6.0)), {1, -1, 0});
  Directions directions;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const glm::dmat3 turn = rotation(static_cast<double>(i / 3) * 2 * std::numbers::pi / 3, {0, 0, 1});
    directions[i] = turn * (tilt * trio[i % 3]);
  }
  return directions;
}

/// Returns the smallest rotation that takes +z to the unit vector `direction`.
glm::dmat3 turnFromZ(const glm::dvec3& direction) {
  constexpr double kNearlyOne = 0.9999;
  if (direction.z >= kNearlyOne) return glm::dmat3(1);
  if (direction.z <= -kNearlyOne) return rotation(std::numbers::pi, {0, 1, 0});
  return rotation(std::acos(direction.z), glm::cross(glm::dvec3(0, 0, 1), direction));
}

/// `direction` is the unit vector from the parent's centre to that of this ball.
void writeBall(NffWriter& out, const Directions& children, const glm::dvec3& centre, double radius,
               const glm::dvec3& direction, std::uint32_t generationsLeft) {
  out.sphere(centre, radius);
  if (generationsLeft == 0) return;
  const glm::dmat3 turn = turnFromZ(direction);
  const double distance = radius * (1 + kRatio);
  for (const glm::dvec3& child : children) {
    const glm::dvec3 towards = turn * child;
    writeBall(out, children, centre + distance * towards, radius * kRatio, towards, generationsLeft - 1);
  }
}

}  // namespace

std::uint64_t ballsPrimitives(std::uint32_t size) {
  std::uint64_t spheres = 1;
  for (std::uint32_t i = 0; i < size; ++i) spheres = 9 * spheres + 1;
  return spheres + 2;
}

void writeBalls(NffWriter& out, std::uint32_t size) {
  out.background(kSkyBlue);
  out.view({{2.1, 1.3, 1.7}, {0, 0, 0}, {0, 0, 1}, 45, 0.01});
  out.light({4, 3, 2});
  out.light({1, -4, 4});
  out.light({-3, 1, 5});
  out.surface({{1, 0.75, 0.33}, 0.8, 0, 0, 0, 1});
  out.square(12, -0.5);
  out.surface({{1, 0.9, 0.7}, 0.5, 0.5, 37, 0, 1});
  writeBall(out, childDirections(), {0, 0, 0}, 0.5, {0, 0, 1}, size);
}

}  // namespace candela::generate
