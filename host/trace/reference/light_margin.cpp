// Distances of lights from surfaces.
#include "host/trace/reference/light_margin.h"

#include <algorithm>
#include <cmath>

namespace candela::reference {

double LightMargin::margin(double reach) const { return fraction_ * std::max(maxNorm(point_), reach); }

bool LightMargin::isIn(const dvec3& at, const dvec3& normal, double reach) const {
  const dvec3 size = abs(normal);
  return std::abs(dot(normal, point_ - at)) <= margin(reach) * (size.x + size.y + size.z);
}

bool LightMargin::contains(const TriangleShape& triangle, double, bool) const {
  const double reach = std::max({maxNorm(triangle.corner), maxNorm(triangle.corner1), maxNorm(triangle.corner2)});
  return isIn(triangle.corner, triangle.areaNormal(), reach);
}

bool LightMargin::contains(const PlaneShape& plane, double, bool) const {
  return isIn(plane.point, plane.unitNormal, maxNorm(plane.point));
}

bool LightMargin::contains(const BoxShape& box, double t, bool startsHere) const {
  const dvec3 normal = box.normal(ray_, t, startsHere);
  const bool isUpper = normal.x + normal.y + normal.z > 0;
  return isIn(isUpper ? box.max : box.min, normal, std::max(maxNorm(box.min), maxNorm(box.max)));
}

bool LightMargin::contains(const SphereShape& sphere, double t, bool) const {
  const double radius = std::abs(sphere.radius);
  const dvec3 towardsEye = eye_ - sphere.centre;
  const dvec3 outward = towardsEye == dvec3(0) ? dvec3(1, 0, 0) : normalize(towardsEye);
  const dvec3 fromCentre = point_ - sphere.centre;
  const double off = dot(fromCentre, fromCentre) - radius * radius;
  if (!(std::abs(off) <= 2 * radius * margin(maxNorm(sphere.centre + radius * outward)))) return false;
  return isEndAtLight(t, dot(fromCentre, ray_.direction));
}

bool LightMargin::contains(const ConeShape& cone, double t, bool) const {
  const double apexRadius = cone.baseRadius + cone.slope * cone.height;
  const double reach = std::max(maxNorm(cone.base) + cone.baseRadius,
                                maxNorm(cone.base + cone.height * cone.axis) + apexRadius);
  const dvec3 fromBase = point_ - cone.base;
  const double z = dot(fromBase, cone.axis);
  const dvec3 across = fromBase - z * cone.axis;
  const double rho = cone.baseRadius + cone.slope * z;
  const double off = length(across) - rho;
  if (!(std::abs(off) <= margin(reach) * std::sqrt(1 + cone.slope * cone.slope))) return false;
  const double dz = dot(ray_.direction, cone.axis);
  const dvec3 dAcross = ray_.direction - dz * cone.axis;
  const double dRho = cone.slope * dz;
  const double a = dot(dAcross, dAcross) - dRho * dRho;
  return isEndAtLight(t, (dot(across, dAcross) - rho * dRho) / a);
}

}  // namespace candela::reference
