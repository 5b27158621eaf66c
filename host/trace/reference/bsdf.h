// Evaluates and samples the scattering of light at surfaces: docs/light-transport.md section 5. Directions are unit
// vectors in the shading frame (z is the shading normal, on the side of wo) and point away from the surface. wi may be
// any direction of the sphere; each lobe determines the side of the surface to which it scatters.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "host/scene/scene.h"
#include "host/trace/reference/bsdf_value.h"
#include "host/trace/reference/dispersion.h"
#include "host/trace/reference/interface_bsdf.h"
#include "host/trace/reference/surface_bsdf.h"

namespace candela::reference {

using glm::dvec2;
using glm::dvec3;

/// The side of the surface to which a direction points: that of wo, or the other.
enum class Side : std::uint8_t { reflection, transmission };

inline Side sideOf(const dvec3& wi) { return wi.z < 0 ? Side::transmission : Side::reflection; }

class Bsdf {
 public:
  explicit Bsdf(const scene::Material& material);

  /// Replaces the lobes by those of a surface as seen from `wo`. `outside`: wo is on the side to which it is oriented.
  /// `choice`: nothing if the surface does not disperse light.
  void setSurface(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside, bool isCoatAlone = false,
                  const std::optional<ChannelChoice>& choice = std::nullopt) {
    if (surface.bareInterface)
      interface_.emplace(surface, wo, outside);
    else if (choice)
      dispersive_.emplace(surface, wo, outside, isCoatAlone, *choice);
    else
      surface_.emplace(surface, wo, outside, isCoatAlone);
  }

  bool isMirror() const { return mirror_; }
  bool isBlack() const { return !surface() && !interface_ && !mirror_ && weightSum() == 0; }
  /// Multiplies the colours of the lobes by that of a texture.
  void scaleBaseColour(const dvec3& scale);
  /// Returns the sum of the lobes' weights times their colours.
  dvec3 albedo() const;
  /// Returns whether some lobe with a density scatters to this side. Light sampling can only contribute there.
  bool scattersTo(Side side) const {
    if (interface_) return !interface_->isSmooth() && (side == Side::reflection || interface_->transmits());
    if (surface()) return side == Side::reflection || surface()->transmits();
    return side == Side::reflection && (diffuse_ > 0 || glossy_ > 0);
  }
  bool hasSmoothLobe() const { return scattersTo(Side::reflection) || scattersTo(Side::transmission); }

  /// Returns diffuse, glossy, or `refract` for the dielectric lobe. Not for mirrors and black surfaces.
  render::Lobe chooseLobe(double u) const;

  /// Returns the sum over all lobes with a density. The integrator multiplies f by |cos wi|.
  BsdfValue evaluate(const dvec3& wo, const dvec3& wi) const;
  /// Returns the factor of diffuseLobe() for light that arrives at this cosine: see SurfaceBsdf.
  double diffuseFactor(double cosine) const { return surface_ ? surface_->diffuseFactor(cosine) : 1; }
  /// Returns the diffuse lobe of a surface: its f, and its density divided by the cosine; 0 for other materials.
  BsdfValue diffuseLobe() const {
    if (dispersive_) return dispersive_->diffuseLobe();
    return surface_ ? surface_->diffuseLobe() : BsdfValue{};
  }
  /// Samples a direction from lobe `diffuse` or `glossy`. It may be on a side to which the lobe does not scatter; its
  /// density is then 0.
  dvec3 sampleSmooth(render::Lobe lobe, const dvec3& wo, const dvec2& u) const;
  /// Returns the surface by which directions are sampled: with dispersion, that of the chosen channel; or null.
  const SurfaceBsdf* surface() const {
    if (dispersive_) return &dispersive_->chosen();
    return surface_ ? &*surface_ : nullptr;
  }
  /// Returns the single interface that the surface is, or null.
  const InterfaceBsdf* interface() const { return interface_ ? &*interface_ : nullptr; }

  DeltaSample sampleMirror(const dvec3& wo) const;
  /// `into`: the ray arrived on the side to which the surface is oriented. The weight includes the choice of the lobe.
  DeltaSample sampleDielectric(const dvec3& wo, bool into, double u) const;

 private:
  double weightSum() const { return diffuse_ + glossy_ + dielectric_; }
  void addDiffuse(const dvec3& wo, const dvec3& wi, BsdfValue& value) const;
  void addGlossy(const dvec3& wo, const dvec3& wi, BsdfValue& value) const;

  std::optional<SurfaceBsdf> surface_;
  std::optional<DispersiveBsdf> dispersive_;  ///< instead of `surface_`
  std::optional<InterfaceBsdf> interface_;    ///< instead of `surface_`
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
