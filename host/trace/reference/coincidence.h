// Surfaces that coincide with the surface on which a ray starts: docs/light-transport.md section 4.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "host/trace/reference/geometry.h"
#include "host/trace/reference/ray.h"

namespace candela::reference {

/// The distance at which a ray hits a surface that coincides with its origin's, less than that of any other hit.
inline constexpr double kAtOnce = 1e-300;

/// Returns whether a distance, or the same perturbed by rounding, is kAtOnce.
inline bool isAtOnce(double distance) { return distance < 2 * kAtOnce; }

/// The tolerance for two flat surfaces in one plane, as a fraction of their largest coordinate: a surface whose
/// vertices are rounded to single precision lies within 2 sqrt(3) 2^-25 of its plane, and so does the other one.
inline constexpr double kCoplanar = 0x1p-21;

/// A flat surface: a triangle, an infinite plane, or a face of a box.
struct FlatSurface {
  std::array<dvec3, 4> corners;
  std::size_t cornerCount;  ///< 0: infinite
  dvec3 point;
  dvec3 normal;  ///< unit

  explicit FlatSurface(const TriangleShape& triangle);
  explicit FlatSurface(const PlaneShape& plane);
  /// The face of a box that this outward normal has.
  FlatSurface(const BoxShape& box, const dvec3& outward);
};

/// Returns whether two flat surfaces lie in one plane.
bool areCoplanar(const FlatSurface& a, const FlatSurface& b);

/// Returns the flat surface on which a ray starts; nothing on a curved one.
std::optional<FlatSurface> flatOrigin(const Shape& shape, const Ray& ray);

/// Returns whether the shape is the same sphere, cone or box. A negative radius makes no difference.
bool isSame(const Shape& shape, const SphereShape& sphere);
bool isSame(const Shape& shape, const ConeShape& cone);
bool isSame(const Shape& shape, const BoxShape& box);

/// Returns whether two shapes coincide in part of their surfaces: the same bodies, or flat ones in one plane. A box is
/// not flat here.
bool coincide(const Shape& a, const Shape& b);

}  // namespace candela::reference
