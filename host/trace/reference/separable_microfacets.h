// Microfacets that are masked for each direction on its own: docs/light-transport.md sections 5.14 and 5.15. Directions
// are in the shading frame.
#pragma once
#include "host/scene/interface.h"
#include "host/trace/reference/microfacets.h"

namespace candela::reference {

class SeparableMicrofacets {
 public:
  /// A smooth interface has the normals of GGX. `roughness` and `anisotropy` as for Microfacets.
  explicit SeparableMicrofacets(scene::Interface shape, double roughness, double anisotropy = 0);

  /// Returns the larger one of the roughnesses along the axes.
  double alpha() const { return ggx_.alpha(); }
  /// Density of normals, such that the integral of D cosH is 1.
  double distribution(const dvec3& h) const;
  /// Smith's masking for one direction, on either side.
  double masking(const dvec3& w) const;
  /// Returns the distribution times the masking for both directions.
  double masked(const dvec3& h, const dvec3& wo, const dvec3& wi) const {
    return distribution(h) * masking(wo) * masking(wi);
  }
  /// Density of the half vectors that sampleNormal() returns.
  double normalPdf(const dvec3& wo, const dvec3& h) const;
  dvec3 sampleNormal(const dvec3& wo, const dvec2& u) const;

 private:
  /// Returns the square of the slope to the normal, in units of alpha in its direction.
  double scaledSlopeSquared(const dvec3& h) const;

  Microfacets ggx_;
  bool isBeckmann_;
};

}  // namespace candela::reference
