// A diffuse base below a dielectric interface, mixed with a metal, below a sheen and a coat.
#include "host/trace/reference/surface_bsdf.h"

#include <algorithm>
#include <cmath>

#include "host/image/film.h"
#include "host/trace/reference/fresnel.h"
#include "host/trace/reference/sampling.h"

namespace candela::reference {
namespace {

// Returns D V.
double shapeOf(const Microfacets& microfacets, const dvec3& wo, const dvec3& wi, const dvec3& h) {
  return microfacets.distribution(h) * microfacets.maskingShadowing(wo, wi) / (4 * wo.z * wi.z);
}

}  // namespace

double coatReflectance(double weight, double cosine) {
  return weight * std::lerp(0.04, 1.0, std::pow(std::max(0.0, 1 - cosine), 5));
}

SurfaceBsdf::SurfaceBsdf(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside, bool isCoatAlone)
    : wo_(wo),
      microfacets_(surface.roughness, surface.anisotropy),
      coat_{Microfacets(surface.coatRoughness), 0, 0},
      sheen_(surface, wo),
      metalness_(surface.metalness),
      opaque_((1 - metalness_) * (1 - double{surface.transmissionWeight})),
      bases_(surface, wo, outside),
      glass_(surface, bases_, microfacets_, wo, outside, 1 - metalness_ - opaque_),
      filmThickness_(surface.filmWeight > 0 ? surface.filmThickness : 0),
      conductor_(surface.conductor) {
  coat_.reflectance = isCoatAlone ? 1 : coatReflectance(surface.coatWeight, wo.z);
  coat_.factor = coat_.reflectance / coat_.microfacets.albedo(wo).white;
  const SingleScattering single = microfacets_.albedo(wo);
  const double lost = 1 / single.white - 1;
  const dvec3 base(surface.baseColour);
  const double weight = bases_.dielectricWeight;
  const dvec3 metalFactor = 1.0 + lost * bases_.metal.normal;
  metal_ = metalFactor * bases_.metal;
  conductorFactor_ = metalFactor * base;
  dielectric_ = weight * (1.0 + lost * bases_.dielectricCompensation) * bases_.dielectric;
  const dvec3 layer = dielectric_.albedo(single);
  diffuse_ = opaque_ * std::max(0.0, 1 - largestOf(layer)) * base;
  const double reflecting = weight * largestOf(bases_.dielectric.albedo(single));
  const double specular = image::luminance(opaque_ * layer + metalness_ * metal_.albedo(single));
  if (surface.plastic) {
    plastic_.emplace(surface, wo);
    diffuse_ = plastic_->baseAlbedo();
    weigh(image::luminance(diffuse_), image::luminance(plastic_->reflected()), 0);
    return;
  }
  weigh(image::luminance(diffuse_), specular,
        (1 - metalness_ - opaque_) * std::lerp(image::luminance(base), 1.0, reflecting));
}

void SurfaceBsdf::weigh(double diffuse, double specular, double glass) {
  const double total = diffuse + specular + glass;
  const double below = 1 - coat_.reflectance;
  const double sheen = image::luminance(sheen_.albedo());
  if (sheen > 0) sheenProbability_ = below * sheen / (sheen + (1 - sheen_.takenFraction()) * total);
  const double base = below - sheenProbability_;
  diffuseProbability_ = total > 0 ? base * diffuse / total : 0;
  glassProbability_ = total > 0 ? base * glass / total : 0;
  specularProbability_ = base - diffuseProbability_ - glassProbability_;
}

BsdfValue SurfaceBsdf::evaluate(const dvec3& wi) const {
  if (wo_.z <= 0 || wi.z == 0) return {};
  if (wi.z > 0) return evaluateReflection(wi);
  if (!transmits()) return {};
  const BsdfValue transmitted = glass_.evaluate(wo_, wi);
  return {(1 - coat_.reflectance) * (1 - sheen_.takenFraction()) * transmitted.f, glassProbability_ * transmitted.pdf};
}

BsdfValue SurfaceBsdf::diffuseLobe() const {
  const double below = sheen_.exists() ? 1 - sheen_.takenFraction() : 1;
  return {below * (1 - coat_.reflectance) / kPi * diffuse_, diffuseProbability_ / kPi};
}

dvec3 SurfaceBsdf::metalAt(double cosine) const {
  if (!conductor_) return metal_.at(cosine);
  return conductorFactor_ * conductorReflectance(cosine, conductor_->ior, conductor_->extinction);
}

BsdfValue SurfaceBsdf::evaluatePlastic(const dvec3& wi) const {
  const dvec3 h = normalize(wo_ + wi);
  const double normalPdf = plastic_->microfacets().normalPdf(wo_, h);
  return {diffuseFactor(wi.z) / kPi * diffuse_ + plastic_->reflection(wi),
          diffuseProbability_ * wi.z / kPi + specularProbability_ * normalPdf / (4 * dot(wo_, h))};
}

BsdfValue SurfaceBsdf::evaluateBase(const dvec3& wi) const {
  const dvec3 h = normalize(wo_ + wi);
  const double cosine = dot(wo_, h);
  dvec3 reflectance = opaque_ * dielectric_.at(cosine) + metalness_ * metalAt(cosine);
  double reflecting = specularProbability_;
  if (transmits()) {
    reflectance += glass_.reflectance(cosine);
    reflecting += glassProbability_ * glass_.reflectionProbability(cosine);
  }
  return {diffuse_ / kPi + reflectance * shapeOf(microfacets_, wo_, wi, h),
          diffuseProbability_ * wi.z / kPi + reflecting * microfacets_.normalPdf(wo_, h) / (4 * cosine)};
}

BsdfValue SurfaceBsdf::evaluateReflection(const dvec3& wi) const {
  BsdfValue value = plastic_ ? evaluatePlastic(wi) : evaluateBase(wi);
  if (sheen_.exists()) {
    value.f = (1 - sheen_.takenFraction()) * value.f + sheen_.value(wo_, wi);
    value.pdf += sheenProbability_ * capPdf(1);
  }
  if (coat_.reflectance == 0) return value;
  const dvec3 h = normalize(wo_ + wi);
  value.f = (1 - coat_.reflectance) * value.f + coat_.factor * shapeOf(coat_.microfacets, wo_, wi, h);
  value.pdf += coat_.reflectance * coat_.microfacets.normalPdf(wo_, h) / (4 * dot(wo_, h));
  return value;
}

SurfaceSample SurfaceBsdf::sample(double choice, const dvec2& u) const {
  const bool coated = choice < coat_.reflectance;
  const double sheenEnd = coat_.reflectance + sheenProbability_;
  if (!coated && choice < sheenEnd) return {render::Lobe::sheen, sampleCap(u, 1), 0};
  if (!coated && choice < sheenEnd + diffuseProbability_) {
    return {render::Lobe::diffuse, sampleCosineHemisphere(u), 0};
  }
  const Microfacets& microfacets = coated ? coat_.microfacets : microfacets_;
  const dvec3 h = !coated && plastic_ ? plastic_->microfacets().sampleNormal(wo_, u) : microfacets.sampleNormal(wo_, u);
  const double cosine = dot(wo_, h);
  if (!coated && choice >= 1 - glassProbability_ * (1 - glass_.reflectionProbability(cosine))) {
    return {render::Lobe::refract, glass_.transmit(wo_, h), microfacets.alpha()};
  }
  return {coated ? render::Lobe::coat : render::Lobe::glossy, 2 * cosine * h - wo_, microfacets.alpha()};
}

}  // namespace candela::reference
