// The lobes of a surface with OpenPBR's parameters, as seen from one direction: docs/light-transport.md section 5.4.
#pragma once
#include "host/reference/bsdf_value.h"
#include "host/reference/microfacets.h"
#include "host/render/path_record.h"
#include "host/scene/surface_parameters.h"

namespace candela::reference {

class SurfaceBsdf {
 public:
  /// Computes all weights for `wo`, whose z is positive, in the shading frame.
  SurfaceBsdf(const scene::SurfaceParameters& surface, const dvec3& wo);

  /// Returns diffuse or glossy.
  render::Lobe chooseLobe(double u) const;
  /// Returns the sum over all lobes.
  BsdfValue evaluate(const dvec3& wi) const;
  /// Samples a direction, which may be below the surface.
  dvec3 sample(render::Lobe lobe, const dvec2& u) const;
  double alpha() const { return microfacets_.alpha(); }

 private:
  /// A reflectance that rises from `normal` to `grazing`, and its factor for light that is reflected more than once.
  struct Schlick {
    dvec3 normal;
    dvec3 grazing;
    dvec3 compensation;

    dvec3 at(double cosine) const;
    dvec3 albedo(const SingleScattering& single) const;
  };

  dvec3 reflectance(double cosine) const;

  dvec3 wo_;
  Microfacets microfacets_;
  double metalness_;
  Schlick metal_;
  Schlick dielectric_;
  dvec3 diffuse_{0};
  double diffuseProbability_ = 0;
};

}  // namespace candela::reference
