// The part of a surface that reflects and transmits light: docs/light-transport.md section 5.5.
#pragma once
#include "host/scene/surface_parameters.h"
#include "host/trace/reference/bsdf_value.h"
#include "host/trace/reference/microfacets.h"
#include "host/trace/reference/reflectance.h"

namespace candela::reference {

class RoughGlass {
 public:
  /// `bases`: reflectances from outside. `weight` of the glass among the surface's parts; `outside`: wo is on the
  /// side to which the surface is oriented.
  RoughGlass(const scene::SurfaceParameters& surface, const BaseReflectances& bases, const Microfacets& microfacets,
             const dvec3& wo, bool outside, double weight);

  /// Returns the factor of microfacets that reflect, for wo.h = `cosine`, their weight and compensation included.
  dvec3 reflectance(double cosine) const;
  /// Returns the probability with which a sampled microfacet reflects, not transmits.
  double reflectionProbability(double cosine) const;
  /// Returns the direction in which a microfacet transmits light, if its reflection is not total.
  dvec3 transmit(const dvec3& wo, const dvec3& h) const;
  /// Returns f and the density of transmit() for a direction below the surface.
  BsdfValue evaluate(const dvec3& wo, const dvec3& wi) const;

 private:
  /// Returns the cosine on the side of the lower index of refraction; nothing is refracted if it is 0.
  double outerCosine(double cosine) const;
  dvec3 schlick(double cosine) const;
  /// Returns the fraction of light that is not transmitted.
  dvec3 kept(double cosine) const;
  BsdfValue evaluateThin(const dvec3& wo, const dvec3& wi) const;
  BsdfValue evaluateRefracted(const dvec3& wo, const dvec3& wi) const;

  Microfacets microfacets_;
  bool isThin_;
  double here_ = 1;    ///< index of refraction on wo's side
  double beyond_ = 1;  ///< and on the other
  Reflectance dielectric_;
  std::optional<FilmOnGlass> film_;
  dvec3 base_;
  dvec3 factor_;  ///< weight and compensation
};

}  // namespace candela::reference
