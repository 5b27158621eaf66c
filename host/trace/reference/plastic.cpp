// Distributions of normals by their slopes, and the base by the light that the boundary transmits.
#include "host/trace/reference/plastic.h"

#include <algorithm>
#include <cmath>

#include "host/scene/energy/energy_tables.h"
#include "host/trace/reference/fresnel.h"
#include "host/trace/reference/microfacets.h"
#include "host/trace/reference/sampling.h"
#include "host/trace/reference/table_axis.h"

namespace candela::reference {
namespace {

double squaredTangent(const dvec3& w) { return (w.x * w.x + w.y * w.y) / (w.z * w.z); }

// The rational approximation of Walter et al. (2007); `a` is the cotangent divided by alpha.
double beckmannMasking(double a) {
  if (a >= 1.6) return 1;
  return (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a);
}

}  // namespace

PlasticLobes::PlasticLobes(const scene::SurfaceParameters& surface, const dvec3& wo)
    : plastic_(*surface.plastic),
      base_(surface.baseColour),
      specular_(surface.specularColour),
      ior_(surface.ior),
      alpha_(Microfacets(surface.roughness).alpha()),
      wo_(wo),
      exitFactor_(1 / (ior_ * ior_ * (1 - double{plastic_.internalReflectance}))) {}

double PlasticLobes::fresnelReflectance(double cosine) const {
  return fresnel(std::min(cosine, 1.0), 1 / ior_).reflectance;
}

double PlasticLobes::transmittance(double cosine) const {
  if (plastic_.boundary == scene::PlasticBoundary::smooth) return 1 - fresnelReflectance(cosine);
  const TableAxis axis(cosine, scene::Plastic::kNodes);
  return std::lerp(double{plastic_.transmittances[axis.node]}, double{plastic_.transmittances[axis.node + 1]},
                   axis.part);
}

dvec3 PlasticLobes::baseAlbedo() const {
  const double entering = transmittance(wo_.z);
  if (!plastic_.isNonlinear) return entering * base_;
  const double internal = plastic_.internalReflectance;
  return entering * (1 - internal) * base_ / (1.0 - internal * base_);
}

dvec3 PlasticLobes::reflected() const { return (1 - transmittance(wo_.z)) * specular_; }

double PlasticLobes::distribution(const dvec3& h) const {
  const double scaled = squaredTangent(h) / (alpha_ * alpha_), cosine4 = std::pow(h.z, 4);
  const double falloff = isBeckmann() ? std::exp(-scaled) : 1 / ((1 + scaled) * (1 + scaled));
  return falloff / (kPi * alpha_ * alpha_ * cosine4);
}

double PlasticLobes::masking(const dvec3& w) const {
  const double slope = alpha_ * std::sqrt(squaredTangent(w));
  if (isBeckmann()) return slope == 0 ? 1 : beckmannMasking(1 / slope);
  return 2 / (1 + std::sqrt(1 + slope * slope));
}

dvec3 PlasticLobes::reflection(const dvec3& wi) const {
  const dvec3 h = normalize(wo_ + wi);
  const double shape = distribution(h) * masking(wo_) * masking(wi) / (4 * wo_.z * wi.z);
  return fresnelReflectance(dot(wo_, h)) * shape * specular_;
}

double PlasticLobes::normalPdf(const dvec3& h) const {
  if (isBeckmann()) return distribution(h) * h.z;
  return distribution(h) * masking(wo_) * dot(wo_, h) / wo_.z;
}

dvec3 PlasticLobes::sampleNormal(const dvec2& u) const {
  if (!isBeckmann()) return Microfacets(std::sqrt(alpha_)).sampleNormal(wo_, u);
  const dvec2 disc = sampleDisc(u);
  const double q = std::min(dot(disc, disc), 1 - 0x1p-24);
  if (q == 0) return {0, 0, 1};
  const dvec2 slope = alpha_ * std::sqrt(-std::log1p(-q) / q) * disc;
  return normalize(dvec3(slope, 1));
}

}  // namespace candela::reference
