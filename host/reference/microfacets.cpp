// GGX by its slopes, Smith's masking by Lambda.
#include "host/reference/microfacets.h"

#include <algorithm>
#include <cmath>

#include "host/energy/energy_tables.h"
#include "host/reference/sampling.h"
#include "host/reference/table_axis.h"

namespace candela::reference {
namespace {

double interpolate(const energy::Table& table, const TableAxis& x, const TableAxis& y) {
  const auto along = [&](std::size_t j) {
    const std::size_t first = j * energy::kNodes + x.node;
    return std::lerp(double{table[first]}, double{table[first + 1]}, x.part);
  };
  return std::lerp(along(y.node), along(y.node + 1), y.part);
}

}  // namespace

Microfacets::Microfacets(double roughness)
    : roughness_(std::max(roughness, double{static_cast<float>(energy::kMinRoughness)})),
      alpha_(roughness_ * roughness_) {}

double Microfacets::distribution(const dvec3& h) const {
  if (h.z <= 0) return 0;
  const double cosSquared = h.z * h.z;
  const double slopeSquared = (h.x * h.x + h.y * h.y) / cosSquared;
  const double falloff = 1 + slopeSquared / (alpha_ * alpha_);
  return 1 / (kPi * alpha_ * alpha_ * cosSquared * cosSquared * falloff * falloff);
}

double Microfacets::lambda(const dvec3& w) const {
  const double tanSquared = (w.x * w.x + w.y * w.y) / (w.z * w.z);
  return (std::sqrt(1 + alpha_ * alpha_ * tanSquared) - 1) / 2;
}

double Microfacets::maskingShadowing(const dvec3& wo, const dvec3& wi) const {
  return 1 / (1 + lambda(wo) + lambda(wi));
}

double Microfacets::normalPdf(const dvec3& wo, const dvec3& h) const {
  return distribution(h) * dot(wo, h) / (wo.z * (1 + lambda(wo)));
}

dvec3 Microfacets::sampleNormal(const dvec3& wo, const dvec2& u) const {
  const dvec3 stretch(alpha_, alpha_, 1);
  const dvec3 onHemisphere = normalize(stretch * wo);
  const dvec3 onCap = sampleCap(u, 1 + onHemisphere.z);
  return normalize(stretch * (onHemisphere + onCap));
}

SingleScattering Microfacets::albedo(double cosine) const {
  const TableAxis x(cosine * (1 + alpha_) / (cosine + alpha_), energy::kNodes), y(roughness_, energy::kNodes);
  const double white = interpolate(energy::kWhite, x, y);
  const double tilted = std::max(0.0, 1 - cosine - alpha_ * interpolate(energy::kTilt, x, y));
  return {white, white * std::pow(tilted, 5)};
}

}  // namespace candela::reference
