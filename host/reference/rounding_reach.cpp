// The points from which each kind of shape is computed.
#include "host/reference/rounding_reach.h"

#include <algorithm>
#include <cmath>

namespace candela::reference {
namespace {

struct ReachOfShape {
  const dvec3& eye;

  RoundingReach operator()(const SphereShape& sphere) const {
    const dvec3 towards = eye - sphere.centre;
    const dvec3 outward = towards == dvec3(0) ? dvec3(0) : std::abs(sphere.radius) * normalize(towards);
    return {sphere.centre + outward, 0, kRoundingBounds.sphereTest};
  }

  RoundingReach operator()(const TriangleShape& triangle) const {
    const dvec3 centre = (triangle.corner + triangle.corner1 + triangle.corner2) / 3.0;
    const double radius = std::max(
        {length(triangle.corner - centre), length(triangle.corner1 - centre), length(triangle.corner2 - centre)});
    return {centre, radius, kRoundingBounds.triangleTest};
  }

  RoundingReach operator()(const BoxShape& box) const {
    return {(box.min + box.max) / 2.0, length(box.max - box.min) / 2, kRoundingBounds.boxTest};
  }

  RoundingReach operator()(const ConeShape& cone) const { return {cone.base, cone.height, kRoundingBounds.coneTest}; }

  RoundingReach operator()(const PlaneShape& plane) const { return {plane.point, 0, kRoundingBounds.planeTest}; }
};

}  // namespace

RoundingReach roundingReach(const Shape& shape, const dvec3& eye) { return std::visit(ReachOfShape{eye}, shape); }

}  // namespace candela::reference
