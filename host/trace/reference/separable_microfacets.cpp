// Distributions of normals by their slopes.
#include "host/trace/reference/separable_microfacets.h"

#include <algorithm>
#include <cmath>

#include "host/trace/reference/sampling.h"

namespace candela::reference {
namespace {

// The rational approximation of Walter et al. (2007); `a` is the cotangent divided by alpha.
double beckmannMasking(double a) {
  if (a >= 1.6) return 1;
  return (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a);
}

}  // namespace

SeparableMicrofacets::SeparableMicrofacets(scene::Interface shape, double roughness, double anisotropy)
    : ggx_(roughness, anisotropy), isBeckmann_(shape == scene::Interface::beckmann) {}

double SeparableMicrofacets::scaledSlopeSquared(const dvec3& h) const {
  const dvec2 slope = dvec2(h) / (h.z * ggx_.alphas());
  return dot(slope, slope);
}

double SeparableMicrofacets::distribution(const dvec3& h) const {
  const double scaled = scaledSlopeSquared(h), cosine4 = std::pow(h.z, 4);
  const double falloff = isBeckmann_ ? std::exp(-scaled) : 1 / ((1 + scaled) * (1 + scaled));
  return falloff / (kPi * ggx_.alphas().x * ggx_.alphas().y * cosine4);
}

double SeparableMicrofacets::masking(const dvec3& w) const {
  const double slope = length(ggx_.alphas() * dvec2(w)) / std::abs(w.z);
  if (isBeckmann_) return slope == 0 ? 1 : beckmannMasking(1 / slope);
  return 2 / (1 + std::sqrt(1 + slope * slope));
}

double SeparableMicrofacets::normalPdf(const dvec3& wo, const dvec3& h) const {
  if (isBeckmann_) return distribution(h) * h.z;
  return distribution(h) * masking(wo) * dot(wo, h) / wo.z;
}

dvec3 SeparableMicrofacets::sampleNormal(const dvec3& wo, const dvec2& u) const {
  if (!isBeckmann_) return ggx_.sampleNormal(wo, u);
  const dvec2 disc = sampleDisc(u);
  const double q = std::min(dot(disc, disc), 1 - 0x1p-24);
  if (q == 0) return {0, 0, 1};
  const dvec2 slope = std::sqrt(-std::log1p(-q) / q) * ggx_.alphas() * disc;
  return normalize(dvec3(slope, 1));
}

}  // namespace candela::reference
