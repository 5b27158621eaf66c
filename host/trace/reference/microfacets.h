// Rough surfaces of GGX microfacets: docs/light-transport.md sections 5.2, 5.3 and 5.12. Directions are in the shading
// frame.
#pragma once
#include <array>
#include <glm/glm.hpp>

namespace candela::reference {

using glm::dvec2;
using glm::dvec3;

/// Directional albedos of light that the microfacets reflect once.
struct SingleScattering {
  double white;    ///< with a reflectance of 1
  double grazing;  ///< with the reflectance (1 - wo.h)^5
};

/// Strength, roughness, azimuth and cosine as fractions of the edges of the tables in
/// host/scene/energy/anisotropic_tables.h, with a = av.
using AnisotropicCoordinates = std::array<double, 4>;

class Microfacets {
 public:
  /// `roughness` in [0, 1] is at least energy::kMinRoughness afterwards. `anisotropy` in [0, 1] is the strength with
  /// which the microfacets are rougher along the frame's x axis.
  explicit Microfacets(double roughness, double anisotropy = 0);

  /// Returns the larger one of the roughnesses along the axes.
  double alpha() const { return alpha_.x; }
  /// Returns the roughnesses along the axes.
  const dvec2& alphas() const { return alpha_; }
  bool isIsotropic() const { return anisotropy_ == 0; }
  /// Density of normals, such that the integral of D cosH is 1.
  double distribution(const dvec3& h) const;
  /// Fraction of the microfacets of normal h that both directions see, with heights correlated.
  double maskingShadowing(const dvec3& wo, const dvec3& wi) const;
  /// Density of the half vectors that sampleNormal() returns.
  double normalPdf(const dvec3& wo, const dvec3& h) const;
  dvec3 sampleNormal(const dvec3& wo, const dvec2& u) const;
  /// Interpolates the energy tables.
  SingleScattering albedo(const dvec3& wo) const;
  /// Not for isotropic microfacets.
  AnisotropicCoordinates anisotropicCoordinates(const dvec3& wo) const;

 private:
  /// Returns the square of the roughness in the azimuth of w.
  double alphaSquaredTowards(const dvec3& w) const;
  double lambda(const dvec3& w) const;
  SingleScattering isotropicAlbedo(double cosine) const;
  SingleScattering anisotropicAlbedo(const dvec3& wo) const;

  double roughness_;
  double anisotropy_;
  dvec2 alpha_;
};

}  // namespace candela::reference
