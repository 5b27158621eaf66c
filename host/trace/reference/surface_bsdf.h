// The lobes of a surface with OpenPBR's parameters, as seen from one direction: docs/light-transport.md section 5.4.
#pragma once
#include <optional>

#include "host/scene/surface_parameters.h"
#include "host/trace/reference/bsdf_value.h"
#include "host/trace/reference/microfacets.h"
#include "host/trace/reference/plastic.h"
#include "host/trace/reference/reflectance.h"
#include "host/trace/reference/rough_glass.h"
#include "host/trace/reference/sheen.h"
#include "host/trace/render/path_record.h"

namespace candela::reference {

/// A sampled direction. A direction on a side to which its lobe does not scatter must be rejected.
struct SurfaceSample {
  render::Lobe lobe;
  dvec3 wi;
  double alpha;  ///< of the microfacets; 0: diffuse or sheen

  bool isOnItsSide() const { return (lobe == render::Lobe::refract) == (wi.z < 0); }
};

/// Returns the reflectance of a coat; `cosine` is that to its normal.
double coatReflectance(double weight, double cosine);

class SurfaceBsdf {
 public:
  /// Computes all weights for `wo`, whose z is positive, in the shading frame. `outside`: wo is on the side to which
  /// the surface is oriented. `isCoatAlone`: the layers below the coat do not count, and the coat has all the light.
  SurfaceBsdf(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside, bool isCoatAlone = false);

  bool transmits() const { return glassProbability_ > 0; }
  /// Returns the power to which the sheen raises a rounded quotient; 0 without a sheen.
  double sheenSteepness() const { return sheen_.steepness(); }
  /// Returns the thickness in nanometres of the thin film that light interferes in; 0 without one.
  double filmThickness() const { return filmThickness_; }
  /// Returns the sum over all lobes.
  BsdfValue evaluate(const dvec3& wi) const;
  /// Returns the diffuse lobe without diffuseFactor(), so that it depends on no direction on its side: its f, and its
  /// density divided by the cosine.
  BsdfValue diffuseLobe() const;
  /// Returns the factor of the diffuse lobe's f for light that arrives at this cosine, which is 1 unless the surface is
  /// plastic.
  double diffuseFactor(double cosine) const { return plastic_ ? plastic_->factorAt(cosine) : 1; }
  /// `choice` decides on the lobe, `u` on the direction.
  SurfaceSample sample(double choice, const dvec2& u) const;

 private:
  /// The layer on top: white microfacets that reflect the fraction `reflectance` of the light.
  struct Coat {
    Microfacets microfacets;
    double reflectance;
    double factor;  ///< `reflectance` and its compensation
  };

  void weigh(double diffuse, double specular, double glass);
  BsdfValue evaluateReflection(const dvec3& wi) const;
  BsdfValue evaluatePlastic(const dvec3& wi) const;
  BsdfValue evaluateBase(const dvec3& wi) const;
  /// Returns the reflectance of the metal for wo.h = `cosine`, with its compensation.
  dvec3 metalAt(double cosine) const;

  dvec3 wo_;
  Microfacets microfacets_;
  Coat coat_;
  Sheen sheen_;
  double metalness_;
  double opaque_;
  BaseReflectances bases_;
  RoughGlass glass_;
  Reflectance dielectric_;  ///< with the factor for light that is reflected more than once
  Reflectance metal_;
  double filmThickness_;
  dvec3 conductorFactor_{0};
  std::optional<scene::Conductor> conductor_;
  std::optional<PlasticLobes> plastic_;  ///< instead of the microfacets, the bases and the glass
  dvec3 diffuse_{0};
  double sheenProbability_ = 0;
  double diffuseProbability_ = 0;
  double specularProbability_ = 0;
  double glassProbability_ = 0;
};

}  // namespace candela::reference
