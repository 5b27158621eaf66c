// Mappings of the unit square to shapes, and frames around a direction: docs/light-transport.md section 2.
#pragma once
#include <glm/glm.hpp>

namespace candela::reference {

using glm::dvec2;
using glm::dvec3;

inline constexpr double kPi = 3.14159265358979323846;

/// Uniform on the unit disc; concentric (Shirley and Chiu, "A Low Distortion Map Between Disk and Square", 1997).
dvec2 sampleDisc(const dvec2& u);

/// Around local z with pdf z / pi.
dvec3 sampleCosineHemisphere(const dvec2& u);

/// Uniform in solid angle on the cap of `height` 1 - cos(thetaMax) around local z, in (0, 2]; 2 is the whole sphere.
dvec3 sampleCap(const dvec2& u, double height);
inline double capPdf(double height) { return 1 / (2 * kPi * height); }

/// Barycentric coordinates (b1, b2) uniform in area.
dvec2 sampleTriangle(const dvec2& u);

/// Density 1 - |x| on [-1, 1].
double sampleTent(double u);

/// Density proportional to exp(-x^2 / 2) - exp(-8) on [-4, 4], by the inverse of the distribution function; `u` is in
/// [0, 1].
double sampleGaussian(double u);

/// Orthonormal, right-handed, `normal` is local z (Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017,
/// switching at z = -0.62).
struct Frame {
  dvec3 tangent;
  dvec3 bitangent;
  dvec3 normal;

  explicit Frame(const dvec3& unitNormal);
  /// The frame whose tangent is the projection of `along` on the plane of the normal; that of only the normal if
  /// `along` is 0 or has no projection.
  Frame(const dvec3& unitNormal, const dvec3& along);
  dvec3 toWorld(const dvec3& v) const { return v.x * tangent + v.y * bitangent + v.z * normal; }
  dvec3 toLocal(const dvec3& v) const { return {dot(v, tangent), dot(v, bitangent), dot(v, normal)}; }
};

}  // namespace candela::reference
