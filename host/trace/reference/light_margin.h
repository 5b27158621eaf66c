// Lights that touch surfaces, which must not hide them: docs/light-transport.md section 6.
#pragma once
#include <cstdint>
#include <optional>

#include "host/trace/reference/geometry.h"
#include "host/trace/reference/ray.h"

namespace candela::reference {

/// The margin as a fraction of the largest coordinate.
inline constexpr double kLightMargin = 0x1p-19;

/// The end of a shadow ray.
struct RayEnd {
  double distance;                     ///< hits from here on do not occlude
  std::uint32_t light = kNoPrimitive;  ///< the light's own primitive, which does not occlude it
  std::optional<dvec3> point{};  ///< the point of the light; none: surfaces hide the light even if it touches them
};

/// Decides for the surfaces that a ray hits before its light whether they contain the light.
class LightMargin {
 public:
  /// `ray` ends at `point`, the light, at `distance`; `eye` is the camera's position. `fraction` is kLightMargin, or
  /// the same perturbed by rounding. `ray` must outlive the object.
  LightMargin(const Ray& ray, double distance, const dvec3& point, const dvec3& eye, double fraction)
      : ray_(ray), distance_(distance), point_(point), eye_(eye), fraction_(fraction) {}

  /// Returns whether the shape contains the light, so that its hit at distance `t` does not occlude. `startsHere`: the
  /// ray starts on the shape.
  bool contains(const TriangleShape& triangle, double, bool) const;
  bool contains(const PlaneShape& plane, double, bool) const;
  bool contains(const BoxShape& box, double t, bool startsHere) const;
  bool contains(const SphereShape& sphere, double t, bool) const;
  bool contains(const ConeShape& cone, double t, bool) const;

 private:
  double margin(double reach) const;
  /// Returns whether the light lies in a flat surface through `at`. The length of `normal` does not matter.
  bool isIn(const dvec3& at, const dvec3& normal, double reach) const;
  /// Returns whether the hit at t is the end at the light of a chord, whose half is `halfChord` long.
  bool isEndAtLight(double t, double halfChord) const { return !(halfChord > 0 && distance_ - t > halfChord); }

  const Ray& ray_;
  double distance_;
  dvec3 point_;
  dvec3 eye_;
  double fraction_;
};

}  // namespace candela::reference
