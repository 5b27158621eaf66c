// Plastic as seen from one direction: docs/light-transport.md section 5.14. Directions are in the shading frame.
#pragma once
#include <glm/glm.hpp>

#include "host/scene/surface_parameters.h"

namespace candela::reference {

using glm::dvec2;
using glm::dvec3;

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
  /// Density of the half vectors that sampleNormal() returns.
  double normalPdf(const dvec3& h) const;
  dvec3 sampleNormal(const dvec2& u) const;
  double alpha() const { return alpha_; }

 private:
  bool isBeckmann() const { return plastic_.boundary == scene::PlasticBoundary::beckmann; }
  double fresnelReflectance(double cosine) const;
  double transmittance(double cosine) const;
  double distribution(const dvec3& h) const;
  /// Smith's masking for one direction.
  double masking(const dvec3& w) const;

  scene::Plastic plastic_;
  dvec3 base_;
  dvec3 specular_;
  double ior_;
  double alpha_;
  dvec3 wo_;
  double exitFactor_;
};

}  // namespace candela::reference
