// Bounds lights, and estimates the light that arrives from within a sphere.
#include "host/trace/reference/light_bounds.h"

#include <algorithm>
#include <cmath>

#include "host/trace/reference/arithmetic.h"

namespace candela::reference {
namespace {

double withSignOf(double magnitude, double sign) { return sign < 0 ? -magnitude : magnitude; }

// The other half of an octahedron, whose corners are those of a square.
dvec2 otherHalf(const dvec2& p) { return {withSignOf(1 - std::abs(p.y), p.x), withSignOf(1 - std::abs(p.x), p.y)}; }

double angleOf(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

}  // namespace

float widerBy(double length) { return static_cast<float>(length * (1 + kBoundsMargin)); }

float containing(const dvec3& axis, const dvec3& otherAxis, double otherCosine) {
  if (otherCosine == -1) return -1;
  const double apart = std::min(dot(axis, otherAxis), 1.0);
  const double apartSine = std::sqrt(std::max(0.0, 1 - apart * apart));
  const double otherSine = std::sqrt(std::max(0.0, 1 - otherCosine * otherCosine));
  if (apartSine * otherCosine + otherSine * apart < 0) return -1;
  const double cosine = std::max(-1.0, apart * otherCosine - apartSine * otherSine);
  return static_cast<float>(std::max(-1.0, cosine - kBoundsMargin));
}

StoredDirection::StoredDirection(const dvec3& direction) {
  const double sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
  dvec2 p(direction.x / sum, direction.y / sum);
  if (direction.z < 0) p = {withSignOf(1 - std::abs(p.y), direction.x), withSignOf(1 - std::abs(p.x), direction.y)};
  const dvec2 steps = glm::floor(8192.0 * (p + 1.0) + 0.5);
  word_ = static_cast<std::uint32_t>(steps.x) + (static_cast<std::uint32_t>(steps.y) << 15);
}

dvec3 StoredDirection::vector() const {
  dvec2 p(word_ % 32768 / 8192.0 - 1, word_ / 32768 / 8192.0 - 1);
  const double z = 1 - std::abs(p.x) - std::abs(p.y);
  if (z < 0) p = otherHalf(p);
  const dvec3 onOctahedron(p, z);
  return onOctahedron / length(onOctahedron);
}

double LightBounds::importance(const PlacedReceiver& receiver, Arithmetic& arithmetic) const {
  const dvec3 fromCentre = receiver.position - dvec3(centre);
  const double squared = dot(fromCentre, fromCentre);
  const double radiusSquared = double{radius} * radius;
  const double intensity = arithmetic.importance(power / std::max({squared, radiusSquared, 0x1p-64}),
                                                 receiver.condition);
  if (squared <= radiusSquared) return intensity;
  const dvec3 away = fromCentre / std::sqrt(squared);
  const double spread = std::asin(std::sqrt(radiusSquared / squared));
  double emitted = arithmetic.cosineOfImportance(dot(axis.vector(), away), receiver.condition);
  if (isTwoSided) emitted = std::abs(emitted);
  const double beyondCone = std::max(0.0, angleOf(emitted) - angleOf(cosine));
  const double byAngle = std::cos(std::max(0.0, beyondCone - spread));
  if (byAngle < (byCosine ? 0 : 1)) return 0;
  double received = arithmetic.cosineOfImportance(-dot(receiver.normal, away), receiver.condition);
  if (receiver.transmits) received = std::abs(received);
  const double slack = 0x1p-11 * receiver.condition;
  return intensity * byAngle * std::max(0.0, std::cos(std::max(0.0, angleOf(received) - spread)) + slack);
}

LightBounds boundsOfTriangle(const std::array<dvec3, 3>& corners, bool isTwoSided) {
  LightBounds bounds;
  Extent extent;
  for (const dvec3& corner : corners) extent.include(corner);
  bounds.centre = extent.middle();
  double reach = 0;
  for (const dvec3& corner : corners) reach = std::max(reach, length(corner - dvec3(bounds.centre)));
  bounds.radius = widerBy(reach);
  const dvec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  bounds.axis = StoredDirection(normal);
  bounds.cosine = static_cast<float>(std::min(dot(bounds.axis.vector(), normal / length(normal)), 1.0) - kBoundsMargin);
  bounds.byCosine = true;
  bounds.isTwoSided = isTwoSided;
  return bounds;
}

LightBounds boundsOfSphere(const glm::vec3& centre, float radius) {
  LightBounds bounds = boundsOfPoint(centre);
  bounds.radius = std::abs(radius);
  bounds.byCosine = true;
  return bounds;
}

LightBounds boundsOfPoint(const glm::vec3& position) {
  LightBounds bounds;
  bounds.centre = position;
  bounds.axis = StoredDirection({0, 0, 1});
  return bounds;
}

LightBounds boundsOfSpot(const glm::vec3& position, const dvec3& direction, double cosine) {
  LightBounds bounds = boundsOfPoint(position);
  bounds.axis = StoredDirection(direction);
  bounds.cosine = containing(bounds.axis.vector(), direction / length(direction), cosine);
  return bounds;
}

}  // namespace candela::reference
