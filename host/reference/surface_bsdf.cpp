// A diffuse base below a dielectric interface, mixed with a metal.
#include "host/reference/surface_bsdf.h"

#include <algorithm>
#include <cmath>

#include "host/image/film.h"
#include "host/reference/sampling.h"

namespace candela::reference {
namespace {

double largestOf(const dvec3& c) { return std::max({c.x, c.y, c.z}); }

dvec3 normalReflectance(const scene::SurfaceParameters& surface) {
  const double ior = surface.ior;
  const double atNormal = std::pow((ior - 1) / (ior + 1), 2);
  return glm::min(atNormal * dvec3(surface.specularColour), dvec3(1));
}

}  // namespace

dvec3 SurfaceBsdf::Schlick::at(double cosine) const {
  return compensation * glm::mix(normal, grazing, std::pow(std::max(0.0, 1 - cosine), 5));
}

dvec3 SurfaceBsdf::Schlick::albedo(const SingleScattering& single) const {
  return compensation * (single.white * normal + single.grazing * (grazing - normal));
}

double coatReflectance(double weight, double cosine) {
  return weight * std::lerp(0.04, 1.0, std::pow(std::max(0.0, 1 - cosine), 5));
}

SurfaceBsdf::SurfaceBsdf(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside, bool isCoatAlone)
    : wo_(wo),
      microfacets_(surface.roughness),
      coat_{Microfacets(surface.coatRoughness), 0, 0},
      metalness_(surface.metalness),
      opaque_((1 - metalness_) * (1 - double{surface.transmissionWeight})),
      glass_(surface, microfacets_, wo, outside, 1 - metalness_ - opaque_) {
  coat_.share = isCoatAlone ? 1 : coatReflectance(surface.coatWeight, wo.z);
  coat_.factor = coat_.share / coat_.microfacets.albedo(wo.z).white;
  const SingleScattering single = microfacets_.albedo(wo.z);
  const double lost = 1 / single.white - 1;
  const dvec3 base(surface.baseColour), coloured = normalReflectance(surface);
  const double weight = surface.specularWeight;
  metal_ = {base, dvec3(1), 1.0 + lost * base};
  dielectric_ = {weight * coloured, dvec3(weight), 1.0 + lost * coloured};
  const dvec3 layer = dielectric_.albedo(single);
  diffuse_ = opaque_ * std::max(0.0, 1 - largestOf(layer)) * base;
  const double reflecting = weight * std::lerp(single.grazing, single.white, largestOf(coloured));
  const double specular = image::luminance(opaque_ * layer + metalness_ * metal_.albedo(single));
  weigh(image::luminance(diffuse_), specular,
        (1 - metalness_ - opaque_) * std::lerp(image::luminance(base), 1.0, reflecting));
}

void SurfaceBsdf::weigh(double diffuse, double specular, double glass) {
  const double total = diffuse + specular + glass;
  const double below = 1 - coat_.share;
  diffuseProbability_ = total > 0 ? below * diffuse / total : 0;
  glassProbability_ = total > 0 ? below * glass / total : 0;
  specularProbability_ = below - diffuseProbability_ - glassProbability_;
}

BsdfValue SurfaceBsdf::evaluate(const dvec3& wi) const {
  if (wo_.z <= 0 || wi.z == 0) return {};
  if (wi.z > 0) return evaluateReflection(wi);
  if (!transmits()) return {};
  const BsdfValue transmitted = glass_.evaluate(wo_, wi);
  return {(1 - coat_.share) * transmitted.f, glassProbability_ * transmitted.pdf};
}

BsdfValue SurfaceBsdf::evaluateReflection(const dvec3& wi) const {
  const dvec3 h = normalize(wo_ + wi);
  const double cosine = dot(wo_, h);
  const auto shape = [&](const Microfacets& m) {
    return m.distribution(h) * m.maskingShadowing(wo_, wi) / (4 * wo_.z * wi.z);
  };
  dvec3 reflectance = opaque_ * dielectric_.at(cosine) + metalness_ * metal_.at(cosine);
  double reflecting = specularProbability_;
  if (transmits()) {
    reflectance += glass_.reflectance(cosine);
    reflecting += glassProbability_ * glass_.strongest(cosine);
  }
  BsdfValue value{diffuse_ / kPi + reflectance * shape(microfacets_),
                  diffuseProbability_ * wi.z / kPi + reflecting * microfacets_.normalPdf(wo_, h) / (4 * cosine)};
  if (coat_.share == 0) return value;
  value.f = (1 - coat_.share) * value.f + coat_.factor * shape(coat_.microfacets);
  value.pdf += coat_.share * coat_.microfacets.normalPdf(wo_, h) / (4 * cosine);
  return value;
}

SurfaceSample SurfaceBsdf::sample(double choice, const dvec2& u) const {
  const bool coated = choice < coat_.share;
  if (!coated && choice < coat_.share + diffuseProbability_) {
    return {render::Lobe::diffuse, sampleCosineHemisphere(u), 0};
  }
  const Microfacets& microfacets = coated ? coat_.microfacets : microfacets_;
  const dvec3 h = microfacets.sampleNormal(wo_, u);
  const double cosine = dot(wo_, h);
  if (!coated && choice >= 1 - glassProbability_ * (1 - glass_.strongest(cosine))) {
    return {render::Lobe::refract, glass_.transmit(wo_, h), microfacets.alpha()};
  }
  return {coated ? render::Lobe::coat : render::Lobe::glossy, 2 * cosine * h - wo_, microfacets.alpha()};
}

}  // namespace candela::reference
