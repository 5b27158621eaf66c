// Fresnel's equations at smooth interfaces, and at microfacets as Walter et al. (2007) combine them.
#include "host/trace/reference/interface_bsdf.h"

#include <algorithm>
#include <cmath>

#include "host/trace/reference/fresnel.h"

namespace candela::reference {
namespace {

constexpr dvec3 kNormal{0, 0, 1};

}  // namespace

InterfaceBsdf::InterfaceBsdf(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside)
    : wo_(wo),
      isSmooth_(surface.isPerfect()),
      isThin_(surface.isThinWalled),
      transmits_(surface.transmissionWeight > 0),
      base_(surface.baseColour),
      specular_(surface.specularColour),
      conductor_(surface.conductor),
      microfacets_(*surface.bareInterface, surface.roughness, surface.anisotropy) {
  (outside || isThin_ ? beyond_ : here_) = surface.ior;
}

double InterfaceBsdf::reflectionProbability(double cosine) const {
  if (!transmits_) return 1;
  const double once = fresnel(std::min(cosine, 1.0), here_ / beyond_).reflectance;
  return isThin_ ? 2 * once / (1 + once) : once;
}

dvec3 InterfaceBsdf::reflected(double cosine) const {
  if (transmits_) return reflectionProbability(cosine) * specular_;
  return conductor_ ? base_ * conductorReflectance(cosine, conductor_->ior, conductor_->extinction) : base_;
}

dvec3 InterfaceBsdf::transmit(const dvec3& h) const {
  if (isThin_) return -wo_;
  const double cosine = std::min(dot(wo_, h), 1.0), ratio = here_ / beyond_;
  return (ratio * cosine - fresnel(cosine, ratio).cosTransmitted) * h - ratio * wo_;
}

DeltaSample InterfaceBsdf::sampleSmooth(double choice) const {
  const dvec3 mirrored(-wo_.x, -wo_.y, wo_.z);
  if (!transmits_) return {mirrored, reflected(wo_.z), render::Lobe::mirror};
  if (choice < reflectionProbability(wo_.z)) return {mirrored, specular_, render::Lobe::reflect};
  return {transmit(kNormal), base_, render::Lobe::refract};
}

SurfaceSample InterfaceBsdf::sample(double choice, const dvec2& u) const {
  const dvec3 h = microfacets_.sampleNormal(wo_, u);
  const double cosine = dot(wo_, h), alpha = microfacets_.alpha();
  if (cosine > 0 && choice >= reflectionProbability(cosine)) return {render::Lobe::refract, transmit(h), alpha};
  return {render::Lobe::glossy, 2 * cosine * h - wo_, alpha};
}

BsdfValue InterfaceBsdf::evaluate(const dvec3& wi) const {
  if (isSmooth_ || wo_.z <= 0 || wi.z == 0) return {};
  if (wi.z > 0) return evaluateReflection(wi);
  return transmits_ ? evaluateTransmission(wi) : BsdfValue{};
}

BsdfValue InterfaceBsdf::evaluateReflection(const dvec3& wi) const {
  const dvec3 h = normalize(wo_ + wi);
  const double cosine = dot(wo_, h);
  return {microfacets_.masked(h, wo_, wi) / (4 * wo_.z * wi.z) * reflected(cosine),
          reflectionProbability(cosine) * microfacets_.normalPdf(wo_, h) / (4 * cosine)};
}

BsdfValue InterfaceBsdf::evaluateTransmission(const dvec3& wi) const {
  dvec3 h = normalize(here_ * wo_ + beyond_ * wi);
  if (h.z < 0) h = -h;
  const double cosO = dot(wo_, h), cosI = dot(wi, h);
  if (cosO <= 0 || cosI >= 0) return {};
  const double sum = here_ * cosO + beyond_ * cosI;
  const double solidAngle = beyond_ * beyond_ * -cosI / (sum * sum);  // of half vectors for that of directions
  const double passing = (1 - reflectionProbability(cosO)) * solidAngle;
  return {passing * microfacets_.masked(h, wo_, wi) * cosO / (wo_.z * -wi.z) * base_,
          passing * microfacets_.normalPdf(wo_, h)};
}

}  // namespace candela::reference
