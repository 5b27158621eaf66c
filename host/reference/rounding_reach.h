// The rounding of the device's intersection tests, as a displacement of the tested ray.
#pragma once
#include "host/reference/geometry.h"
#include "host/reference/rounding.h"

namespace candela::reference {

/// The rounding in the test of a shape has the effect of a displaced ray: by `units` of kRoundoff of the distance of
/// the ray's origin from `centre`, plus `radius`.
struct RoundingReach {
  dvec3 centre;
  double radius;
  double units;

  /// Returns the largest displacement, along each axis, of a ray from `origin`.
  double at(const dvec3& origin) const { return units * kRoundoff * (length(origin - centre) + radius); }
};

/// `eye`: the camera's position, close to which the device stores a point of each sphere.
RoundingReach roundingReach(const Shape& shape, const dvec3& eye);

}  // namespace candela::reference
