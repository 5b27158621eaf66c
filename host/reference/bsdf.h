// How surfaces scatter light: docs/light-transport.md section 5. Directions are unit vectors in the shading frame (z
// the shading normal, on the side of wo), pointing away from the surface.
#pragma once
#include <glm/glm.hpp>

#include "host/render/path_record.h"
#include "host/scene/scene.h"

namespace candela::reference {

using glm::dvec2;
using glm::dvec3;

/// A value of f and the density, per solid angle, with which the choice of a lobe and its sampling find the direction.
struct BsdfValue {
  dvec3 f{0};
  double pdf = 0;
};

/// A direction with density none (mirror, dielectric): `weight` takes the place of f |cos| / pdf.
struct DeltaSample {
  dvec3 wi;
  dvec3 weight;
  render::Lobe lobe;
};

class Bsdf {
 public:
  explicit Bsdf(const scene::Material& material);

  bool isMirror() const { return mirror_; }
  bool isBlack() const { return !mirror_ && weightSum() == 0; }
  /// The lobes' weights times their colours.
  dvec3 albedo() const;
  /// Whether light samples can find it.
  bool hasSmoothLobe() const { return diffuse_ > 0 || glossy_ > 0; }

  /// Diffuse, glossy, or, for the dielectric lobe, `refract`. Not for mirrors and black surfaces.
  render::Lobe chooseLobe(double u) const;

  /// Diffuse and glossy lobe together. 0 where wi or wo is not above the surface.
  BsdfValue evaluate(const dvec3& wo, const dvec3& wi) const;
  /// A direction from lobe `diffuse` or `glossy`; may be below the surface.
  dvec3 sampleSmooth(render::Lobe lobe, const dvec3& wo, const dvec2& u) const;

  DeltaSample sampleMirror(const dvec3& wo) const;
  /// `into`: the ray came from the side to which the surface is oriented. The weight includes the choice of the lobe.
  DeltaSample sampleDielectric(const dvec3& wo, bool into, double u) const;

 private:
  double weightSum() const { return diffuse_ + glossy_ + dielectric_; }

  double diffuse_ = 0;
  double glossy_ = 0;
  double dielectric_ = 0;
  bool mirror_ = false;
  dvec3 diffuseColour_{0};
  dvec3 glossyColour_{0};
  dvec3 specularColour_{0};  ///< of the dielectric or of the mirror
  double exponent_ = 0;
  double ior_ = 1;
};

}  // namespace candela::reference
