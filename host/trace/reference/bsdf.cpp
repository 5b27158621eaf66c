// Lambert, Blinn with Torrance and Sparrow's masking, mirror, and smooth dielectric with Schlick's reflectance.
#include "host/trace/reference/bsdf.h"

#include <algorithm>
#include <cmath>

#include "host/trace/reference/sampling.h"

namespace candela::reference {
namespace {

dvec3 reflectAboutZ(const dvec3& wo) { return {-wo.x, -wo.y, wo.z}; }

// Normalised such that the integral of D cosH over the half vectors is 1 (Walter et al. 2007).
double blinnDistribution(double cosH, double exponent) { return (exponent + 2) / (2 * kPi) * std::pow(cosH, exponent); }

}  // namespace

Bsdf::Bsdf(const scene::Material& material) : mirror_(material.mirror.has_value()) {
  if (const auto& lobe = material.diffuse) {
    diffuse_ = lobe->weight;
    diffuseColour_ = lobe->colour;
  }
  if (const auto& lobe = material.glossy) {
    glossy_ = lobe->weight;
    glossyColour_ = lobe->colour;
    exponent_ = lobe->exponent;
  }
  if (const auto& lobe = material.dielectric) {
    dielectric_ = lobe->weight;
    specularColour_ = lobe->colour;
    ior_ = lobe->ior;
  }
  if (material.mirror) specularColour_ = material.mirror->colour;
}

void Bsdf::scaleBaseColour(const dvec3& scale) {
  diffuseColour_ *= scale;
  specularColour_ *= scale;
  glossyColour_ *= scale;
}

dvec3 Bsdf::albedo() const {
  if (mirror_) return specularColour_;
  return diffuse_ * diffuseColour_ + glossy_ * glossyColour_ + dielectric_ * specularColour_;
}

render::Lobe Bsdf::chooseLobe(double u) const {
  if (u < diffuse_ / weightSum()) return render::Lobe::diffuse;
  if (u < (diffuse_ + glossy_) / weightSum()) return render::Lobe::glossy;
  return render::Lobe::refract;
}

BsdfValue Bsdf::evaluate(const dvec3& wo, const dvec3& wi) const {
  if (dispersive_) return dispersive_->evaluate(wi);
  if (surface_) return surface_->evaluate(wi);
  if (interface_) return interface_->evaluate(wi);
  BsdfValue value;
  addDiffuse(wo, wi, value);
  if (glossy_ > 0) addGlossy(wo, wi, value);
  return value;
}

void Bsdf::addDiffuse(const dvec3& wo, const dvec3& wi, BsdfValue& value) const {
  if (wo.z <= 0 || wi.z <= 0) return;
  value.f += diffuse_ / kPi * diffuseColour_;
  value.pdf += diffuse_ / weightSum() * wi.z / kPi;
}

void Bsdf::addGlossy(const dvec3& wo, const dvec3& wi, BsdfValue& value) const {
  if (wo.z <= 0 || wi.z <= 0) return;
  const dvec3 h = normalize(wo + wi);
  const double cosHO = dot(wo, h);
  const double d = blinnDistribution(h.z, exponent_);
  const double g = std::min(1.0, 2 * h.z * std::min(wo.z, wi.z) / cosHO);
  value.f += glossy_ * d * g / (4 * wo.z * wi.z) * glossyColour_;
  value.pdf += glossy_ / weightSum() * d * h.z / (4 * cosHO);
}

dvec3 Bsdf::sampleSmooth(render::Lobe lobe, const dvec3& wo, const dvec2& u) const {
  if (lobe == render::Lobe::diffuse) return sampleCosineHemisphere(u);

  const dvec2 p = sampleDisc(u);
  const double q = std::min(dot(p, p), 1 - 0x1p-24);
  const double cosH = std::pow(1 - q, 1 / (exponent_ + 2));
  const double sinH = std::sqrt(1 - cosH * cosH);
  const dvec3 h = q == 0 ? dvec3(0, 0, 1) : dvec3(p * (sinH / std::sqrt(q)), cosH);
  return 2 * dot(wo, h) * h - wo;
}

DeltaSample Bsdf::sampleMirror(const dvec3& wo) const {
  return {reflectAboutZ(wo), specularColour_, render::Lobe::mirror};
}

DeltaSample Bsdf::sampleDielectric(const dvec3& wo, bool into, double u) const {
  const dvec3 weight = weightSum() * specularColour_;  // t / p_t = S
  const DeltaSample reflected{reflectAboutZ(wo), weight, render::Lobe::reflect};
  const double eta = into ? 1 / ior_ : ior_;
  const double sin2Squared = eta * eta * (wo.x * wo.x + wo.y * wo.y);
  if (sin2Squared >= 1) return reflected;

  const double cos2 = std::sqrt(1 - sin2Squared);
  const double r0 = std::pow((ior_ - 1) / (ior_ + 1), 2);
  const double reflectance = r0 + (1 - r0) * std::pow(1 - (into ? wo.z : cos2), 5);
  if (u < reflectance) return reflected;
  return {{-eta * wo.x, -eta * wo.y, -cos2}, weight, render::Lobe::refract};
}

}  // namespace candela::reference
