// Reflection at a film whose thickness is comparable to the wavelengths of light: docs/light-transport.md section 5.11.
#pragma once
#include <glm/glm.hpp>

namespace candela::reference {

using glm::dvec3;

/// A film of index `ior` and `thickness` nanometres between air and a base.
struct ThinFilm {
  double ior;
  double thickness;

  /// Returns the reflectance for light from outside, in [0, 1]. `cosine` in (0, 1]; `base` is the reflectance of the
  /// base at normal incidence without the film, per channel.
  dvec3 reflectance(double cosine, const dvec3& base) const;
};

}  // namespace candela::reference
