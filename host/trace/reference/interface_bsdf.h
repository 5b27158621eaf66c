// A single interface between two media, as seen from one direction: docs/light-transport.md section 5.15.
#pragma once
#include "host/scene/surface_parameters.h"
#include "host/trace/reference/bsdf_value.h"
#include "host/trace/reference/separable_microfacets.h"
#include "host/trace/reference/surface_bsdf.h"

namespace candela::reference {

class InterfaceBsdf {
 public:
  /// `surface` must be a bare interface. Arguments are those of SurfaceBsdf.
  InterfaceBsdf(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside);

  bool isSmooth() const { return isSmooth_; }
  bool transmits() const { return transmits_; }
  /// Returns f and the density of a rough interface; 0 for a smooth one.
  BsdfValue evaluate(const dvec3& wi) const;
  /// Samples a rough interface: `choice` decides between reflection and transmission, `u` on the normal.
  SurfaceSample sample(double choice, const dvec2& u) const;
  /// Samples a smooth interface.
  DeltaSample sampleSmooth(double choice) const;

 private:
  /// Returns the factor of what a facet reflects, for wo.h = `cosine`.
  dvec3 reflected(double cosine) const;
  /// Returns the fraction of the light that a facet of a dielectric reflects; 1 for a metal.
  double reflectionProbability(double cosine) const;
  /// Returns the direction in which a facet of a dielectric transmits light, if its reflection is not total.
  dvec3 transmit(const dvec3& h) const;
  BsdfValue evaluateReflection(const dvec3& wi) const;
  BsdfValue evaluateTransmission(const dvec3& wi) const;

  dvec3 wo_;
  bool isSmooth_;
  bool isThin_;
  bool transmits_;
  double here_ = 1;    ///< index of refraction on wo's side
  double beyond_ = 1;  ///< and on the other; of thin walls that of the inside
  dvec3 base_;
  dvec3 specular_;
  std::optional<scene::Conductor> conductor_;
  SeparableMicrofacets microfacets_;
};

}  // namespace candela::reference
