// Reflectances of surfaces for light from outside: docs/light-transport.md sections 5.4 and 5.11.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "host/scene/surface_parameters.h"
#include "host/trace/reference/microfacets.h"

namespace candela::reference {

/// A reflectance that rises from `normal` to `grazing` by Schlick's formula.
struct Reflectance {
  dvec3 normal;
  dvec3 grazing;

  dvec3 at(double cosine) const { return glm::mix(normal, grazing, std::pow(std::max(0.0, 1 - cosine), 5)); }
  /// Returns the mean over the light that microfacets scatter once.
  dvec3 albedo(const SingleScattering& single) const {
    return single.white * normal + single.grazing * (grazing - normal);
  }
};

inline Reflectance operator*(const dvec3& factor, const Reflectance& reflectance) {
  return {factor * reflectance.normal, factor * reflectance.grazing};
}
inline Reflectance operator*(double factor, const Reflectance& reflectance) { return dvec3(factor) * reflectance; }

inline double largestOf(const dvec3& c) { return std::max({c.x, c.y, c.z}); }

/// A thin film on a dielectric, as seen from one direction.
struct FilmOnGlass {
  double weight;
  dvec3 reflectance;
  Reflectance absorbed;  ///< by the dielectric beside the film: it neither reflects nor transmits this light
};

/// The reflectances of a surface's two kinds of base, seen from `wo` through its film. `outside`: wo is on the side to
/// which the surface is oriented.
struct BaseReflectances {
  Reflectance dielectric;
  double dielectricWeight;       ///< factor of the dielectric's reflectance; 1 with a film, below which it is included
  dvec3 dielectricCompensation;  ///< reflectance by which the dielectric's multiple scattering is compensated
  std::optional<FilmOnGlass> film;
  Reflectance metal;  ///< of a conductor: the approximation by which its lobe is chosen

  BaseReflectances(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside);
};

}  // namespace candela::reference
