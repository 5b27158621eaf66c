// Intersections of rays with spheres and cones, as the roots of quadratics.
#include <algorithm>
#include <cmath>
#include <utility>

#include "host/trace/reference/geometry.h"

namespace candela::reference {
namespace {

// Returns the roots of a t^2 + 2 b t + c = 0, neither as a difference of nearly equal numbers; NaN or infinite if there
// are none or only one.
std::pair<double, double> roots(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return {kNoHit, kNoHit};
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  return {q / a, c / q};
}

}  // namespace

SphereShape::SphereShape(const scene::Sphere& sphere) : centre(sphere.centre), radius(sphere.radius) {}

double SphereShape::distance(const Ray& ray, bool startsHere) const {
  const dvec3 fromCentre = ray.origin - centre;
  const double b = dot(fromCentre, ray.direction);
  if (startsHere) return positiveOrNoHit(-2 * b);

  const auto [t1, t2] = roots(1, b, dot(fromCentre, fromCentre) - radius * radius);
  const double near = std::min(t1, t2);
  const double far = std::max(t1, t2);
  return positiveOrNoHit(near > 0 && radius > 0 ? near : far);
}

dvec3 SphereShape::normal(const dvec3& point) const { return normalize(point - centre) * std::copysign(1.0, radius); }

// ---------------------------------------------------------------------------------------------------------------------

ConeShape::ConeShape(const scene::Cone& cone)
    : base(cone.base),
      axis(normalize(dvec3(cone.apex) - base)),
      height(length(dvec3(cone.apex) - base)),
      baseRadius(cone.baseRadius),
      slope((cone.apexRadius - baseRadius) / height) {}

double ConeShape::distance(const Ray& ray, bool startsHere) const {
  const dvec3 fromBase = ray.origin - base;
  const double z = dot(fromBase, axis);
  const double dz = dot(ray.direction, axis);
  const dvec3 across = fromBase - z * axis;  // part perpendicular to the axis, and its change along the ray
  const dvec3 dAcross = ray.direction - dz * axis;
  const double rho = baseRadius + slope * z;
  const double dRho = slope * dz;
  // |across + t dAcross|^2 = (rho + t dRho)^2
  const double a = dot(dAcross, dAcross) - dRho * dRho;
  const double b = dot(across, dAcross) - rho * dRho;

  const auto inRange = [&](double t) { return t > 0 && t < kNoHit && z + t * dz >= 0 && z + t * dz <= height; };
  if (startsHere) {
    const double t = -2 * b / a;
    return inRange(t) ? t : kNoHit;
  }
  const auto [t1, t2] = roots(a, b, dot(across, across) - rho * rho);
  return std::min(inRange(t1) ? t1 : kNoHit, inRange(t2) ? t2 : kNoHit);
}

dvec3 ConeShape::normal(const dvec3& point) const {
  const dvec3 fromBase = point - base;
  const dvec3 across = fromBase - dot(fromBase, axis) * axis;
  const double rho = length(across);
  if (rho == 0) return axis * std::copysign(1.0, -slope);  // the apex
  return normalize(across / rho - slope * axis);
}

}  // namespace candela::reference
