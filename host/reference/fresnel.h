// A smooth boundary between two dielectrics: docs/light-transport.md section 9, glass.
#pragma once

namespace candela::reference {

/// What happens to a ray at a boundary; a reflectance of 1 goes with total reflection.
struct Boundary {
  double reflectance;     ///< of unpolarised light, in [0, 1]
  double cosTransmitted;  ///< 0 where the reflection is total
};

/// `cosIncident` in (0, 1]; `eta` > 0 is the index on the ray's side by that behind the boundary.
Boundary fresnel(double cosIncident, double eta);

}  // namespace candela::reference
