// Light scattered by fibres on a surface: docs/light-transport.md section 5.9. Directions are in the shading frame.
#pragma once
#include <glm/glm.hpp>

#include "host/scene/surface_parameters.h"

namespace candela::reference {

using glm::dvec3;

class Sheen {
 public:
  /// Computes the albedo for `wo`, whose z is positive.
  Sheen(const scene::SurfaceParameters& surface, const dvec3& wo);

  bool exists() const { return colour_ != dvec3(0); }
  /// Returns f, for directions above the surface.
  dvec3 value(const dvec3& wo, const dvec3& wi) const;
  /// Returns the directional albedo.
  dvec3 albedo() const { return white_ * colour_; }
  /// Returns the fraction of the light that the sheen takes from the lobes below it.
  double takenFraction() const;
  /// Returns the power of the quotient from which value() follows; 0 without a sheen.
  double steepness() const { return exists() ? 0.5 / alpha_ : 0; }

 private:
  double lambda(double cosine) const;
  /// Returns the logarithm of lambda for cosines below 1/2.
  double fit(double x) const;

  dvec3 colour_;
  double alpha_;
  double factor_;     ///< that bounds the albedo
  double white_ = 0;  ///< albedo of a white sheen
};

}  // namespace candela::reference
