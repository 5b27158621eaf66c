// Bounds of one light or of several, and the point for which a light is chosen: docs/light-transport.md section 6.1.
#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "host/trace/reference/geometry.h"

namespace candela::reference {

class Arithmetic;

/// A direction with 30 bits, on an octahedron.
class StoredDirection {
 public:
  StoredDirection() = default;
  /// `direction` has any length but 0.
  explicit StoredDirection(const dvec3& direction);

  std::uint32_t word() const { return word_; }
  /// Returns the unit vector.
  dvec3 vector() const;

 private:
  std::uint32_t word_ = 0;
};

/// The point for which a light is chosen.
struct LightReceiver {
  dvec3 position;
  StoredDirection normal;  ///< on the side of the light that arrives by reflection
  bool transmits;          ///< light can be scattered to the other side of the normal, too
};

/// A receiver in the space in which bounds are given.
struct PlacedReceiver {
  dvec3 position;
  dvec3 normal;  ///< of length 1
  bool transmits;
  double condition = 1;  ///< of the map from there to the scene, by which it may turn the error of the normal

  explicit PlacedReceiver(const LightReceiver& receiver)
      : position(receiver.position), normal(receiver.normal.vector()), transmits(receiver.transmits) {}
};

/// Lights within a sphere, and the directions in which they emit.
struct LightBounds {
  glm::vec3 centre{0};
  float radius = 0;
  float power = 0;
  StoredDirection axis;
  float cosine = -1;        ///< of the angle between the axis and the normals, or the directions of light
  bool byCosine = false;    ///< light is emitted up to 90 degrees from the normals
  bool isTwoSided = false;  ///< to the other side, too

  /// Returns an upper bound of the light that arrives, apart from a common factor.
  double importance(const PlacedReceiver& receiver, Arithmetic& arithmetic) const;
};

/// Relative enlargement of radii, and absolute one of cones.
inline constexpr double kBoundsMargin = 0x1p-20;
float widerBy(double length);
/// Returns the cosine of a cone around `axis` that contains another cone, and a little more.
float containing(const dvec3& axis, const dvec3& otherAxis, double otherCosine);

/// A box around points.
struct Extent {
  dvec3 low{std::numeric_limits<double>::max()};
  dvec3 high{std::numeric_limits<double>::lowest()};

  void include(const dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  glm::vec3 middle() const { return glm::vec3((low + high) / 2.0); }
};

/// Bounds of a light without its power.
LightBounds boundsOfTriangle(const std::array<dvec3, 3>& corners, bool isTwoSided);
LightBounds boundsOfSphere(const glm::vec3& centre, float radius);
LightBounds boundsOfPoint(const glm::vec3& position);
/// `cosine`: of the cone around `direction`, which has any length.
LightBounds boundsOfSpot(const glm::vec3& position, const dvec3& direction, double cosine);

}  // namespace candela::reference
