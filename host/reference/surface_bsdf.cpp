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

SurfaceBsdf::SurfaceBsdf(const scene::SurfaceParameters& surface, const dvec3& wo)
    : wo_(wo), microfacets_(surface.roughness), metalness_(surface.metalness) {
  const SingleScattering single = microfacets_.albedo(wo.z);
  const double lost = 1 / single.white - 1;
  const dvec3 base(surface.baseColour), coloured = normalReflectance(surface);
  const double weight = surface.specularWeight;
  metal_ = {base, dvec3(1), 1.0 + lost * base};
  dielectric_ = {weight * coloured, dvec3(weight), 1.0 + lost * coloured};
  const dvec3 layer = dielectric_.albedo(single);
  diffuse_ = (1 - metalness_) * std::max(0.0, 1 - largestOf(layer)) * base;
  const double specular = image::luminance(glm::mix(layer, metal_.albedo(single), metalness_));
  const double total = specular + image::luminance(diffuse_);
  diffuseProbability_ = total > 0 ? 1 - specular / total : 0;
}

render::Lobe SurfaceBsdf::chooseLobe(double u) const {
  return u < diffuseProbability_ ? render::Lobe::diffuse : render::Lobe::glossy;
}

dvec3 SurfaceBsdf::reflectance(double cosine) const {
  return glm::mix(dielectric_.at(cosine), metal_.at(cosine), metalness_);
}

BsdfValue SurfaceBsdf::evaluate(const dvec3& wi) const {
  if (wo_.z <= 0 || wi.z <= 0) return {};
  const dvec3 h = normalize(wo_ + wi);
  const double cosine = dot(wo_, h);
  const double d = microfacets_.distribution(h);
  const dvec3 specular = reflectance(cosine) * d * microfacets_.maskingShadowing(wo_, wi) / (4 * wo_.z * wi.z);
  const double reflectedPdf = microfacets_.normalPdf(wo_, h) / (4 * cosine);
  return {diffuse_ / kPi + specular, diffuseProbability_ * wi.z / kPi + (1 - diffuseProbability_) * reflectedPdf};
}

dvec3 SurfaceBsdf::sample(render::Lobe lobe, const dvec2& u) const {
  if (lobe == render::Lobe::diffuse) return sampleCosineHemisphere(u);
  const dvec3 h = microfacets_.sampleNormal(wo_, u);
  return 2 * dot(wo_, h) * h - wo_;
}

}  // namespace candela::reference
