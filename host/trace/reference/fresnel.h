// Smooth boundaries: of two dielectrics (docs/light-transport.md section 9, glass), and of conductors (section 5.10).
#pragma once
#include <glm/glm.hpp>

namespace candela::reference {

/// The continuation of a ray at a boundary. Total reflection has reflectance 1.
struct Boundary {
  double reflectance;     ///< for unpolarised light, in [0, 1]
  double cosTransmitted;  ///< 0 if the reflection is total
};

/// `cosIncident` in (0, 1]; `eta` > 0 is the index of refraction on the ray's side divided by that on the far side of
/// the boundary.
Boundary fresnel(double cosIncident, double eta);

/// Returns the reflectance of a conductor with the complex index `ior` + i `extinction`, for unpolarised light in air.
glm::dvec3 conductorReflectance(double cosIncident, const glm::dvec3& ior, const glm::dvec3& extinction);

}  // namespace candela::reference
