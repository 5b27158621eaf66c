// Inverts placements.
#include "host/trace/accel/instance_space.h"

#include <cmath>

#include "host/trace/accel/primitive_bounds.h"

namespace candela::accel {
namespace {

constexpr double kUnit = 0x1p-24;
constexpr double kPadding = 40 * kUnit;
constexpr double kCoincidentPadding = 32 * kUnit;
constexpr double kPlacementError = 4 * kUnit;  // of a coordinate, as a fraction of the sum of its terms' magnitudes

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double largestRowSum(const glm::dmat3& m) { return largest(scene::magnitudesOf(m) * glm::dvec3(1)); }

glm::dvec3 largestCoordinates(const Aabb& box) {
  return glm::max(glm::abs(glm::dvec3(box.min)), glm::abs(glm::dvec3(box.max)));
}

// Returns the magnitudes of coordinates in the scene: sum_j |A_ij| P_j + |b_i|.
glm::dvec3 placedReach(const scene::Placement& placement, const glm::dvec3& reach) {
  return scene::magnitudesOf(linearPartOf(placement)) * reach + glm::abs(translationOf(placement));
}

}  // namespace

InstanceSpace instanceSpace(const scene::Placement& placement, const Aabb& meshBounds, float coincidentReach) {
  const glm::dmat3 inverse = glm::inverse(linearPartOf(placement));
  const glm::dvec3 origin = -(inverse * translationOf(placement));
  const double stretch = largestRowSum(inverse);
  const double reach = largest(placedReach(placement, largestCoordinates(meshBounds)));
  const double padding = kPadding * (stretch * reach + largest(origin)) +
                         kCoincidentPadding * stretch * double{coincidentReach};
  return {{glm::vec3(inverse[0]), glm::vec3(inverse[1]), glm::vec3(inverse[2]), glm::vec3(origin)},
          static_cast<float>(padding),
          static_cast<float>(kPadding * stretch)};
}

Aabb placedBounds(const scene::Placement& placement, const Aabb& box) {
  const glm::dmat3 linear = linearPartOf(placement);
  const glm::dvec3 centre = 0.5 * (glm::dvec3(box.min) + glm::dvec3(box.max));
  const glm::dvec3 half = 0.5 * box.extent();
  const glm::dvec3 placed = linear * centre + translationOf(placement);
  const glm::dvec3 halfPlaced = scene::magnitudesOf(linear) * half +
                                kPlacementError * placedReach(placement, largestCoordinates(box));
  return paddedBounds(placed - halfPlaced, placed + halfPlaced);
}

}  // namespace candela::accel
