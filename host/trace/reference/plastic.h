// Plastic as seen from one direction: docs/light-transport.md section 5.14. Directions are in the shading frame.
#pragma once
#include "host/scene/surface_parameters.h"
#include "host/trace/reference/separable_microfacets.h"

namespace candela::reference {

class PlasticLobes {
 public:
  /// `surface` must be plastic. The z of `wo` is positive.
  PlasticLobes(const scene::SurfaceParameters& surface, const dvec3& wo);

  /// Returns the albedo of the diffuse base below the boundary.
  dvec3 baseAlbedo() const;
  /// Returns the factor of the diffuse lobe for light that arrives at this cosine. Its mean over a cosine-weighted
  /// hemisphere is 1, apart from interpolation.
  double factorAt(double cosine) const { return transmittance(cosine) * exitFactor_; }
  /// Returns an estimate of the light that the boundary reflects, by which its lobe is chosen.
  dvec3 reflected() const;
  /// Returns f of the boundary, for wi.z > 0.
  dvec3 reflection(const dvec3& wi) const;
  const SeparableMicrofacets& microfacets() const { return microfacets_; }

 private:
  double fresnelReflectance(double cosine) const;
  double transmittance(double cosine) const;

  scene::Plastic plastic_;
  dvec3 base_;
  dvec3 specular_;
  double ior_;
  SeparableMicrofacets microfacets_;
  dvec3 wo_;
  double exitFactor_;
};

}  // namespace candela::reference
