// GGX by its slopes, Smith's masking by Lambda.
#include "host/trace/reference/microfacets.h"

#include <algorithm>
#include <cmath>

#include "host/scene/energy/anisotropic_tables.h"
#include "host/scene/energy/energy_tables.h"
#include "host/trace/reference/sampling.h"
#include "host/trace/reference/table_axis.h"

namespace candela::reference {
namespace {

double interpolateIsotropic(const energy::Table& table, const TableAxis& x, const TableAxis& y) {
  const auto along = [&](std::size_t j) {
    const std::size_t first = j * energy::kNodes + x.node;
    return std::lerp(double{table[first]}, double{table[first + 1]}, x.part);
  };
  return std::lerp(along(y.node), along(y.node + 1), y.part);
}

double interpolateAnisotropic(const energy::AnisotropicTable& table, const AnisotropicCoordinates& coordinates) {
  return interpolateTable(table.data(), coordinates,
                          {energy::kAnisotropicStrengths, energy::kAnisotropicRoughnesses, energy::kAnisotropicAzimuths,
                           energy::kAnisotropicCosines});
}

double scaledCosine(double cosine, double scale) { return cosine * (1 + scale) / (cosine + scale); }

}  // namespace

Microfacets::Microfacets(double roughness, double anisotropy)
    : roughness_(std::max(roughness, double{static_cast<float>(energy::kMinRoughness)})),
      anisotropy_(anisotropy),
      alpha_(roughness_ * roughness_) {
  if (!isIsotropic()) alpha_.x = std::lerp(alpha_.y, 1.0, anisotropy * anisotropy);
}

double Microfacets::alphaSquaredTowards(const dvec3& w) const {
  const double square = w.x * w.x + w.y * w.y;
  if (isIsotropic() || square == 0) return alpha_.y * alpha_.y;
  return (std::pow(alpha_.x * w.x, 2) + std::pow(alpha_.y * w.y, 2)) / square;
}

double Microfacets::distribution(const dvec3& h) const {
  if (h.z <= 0) return 0;
  const double cosSquared = h.z * h.z;
  const double slopeSquared = (h.x * h.x + h.y * h.y) / cosSquared;
  double falloff = 1 + slopeSquared / (alpha_.y * alpha_.y);
  if (!isIsotropic()) falloff = 1 + (std::pow(h.x / alpha_.x, 2) + std::pow(h.y / alpha_.y, 2)) / cosSquared;
  return 1 / (kPi * alpha_.x * alpha_.y * cosSquared * cosSquared * falloff * falloff);
}

double Microfacets::lambda(const dvec3& w) const {
  const double tanSquared = (w.x * w.x + w.y * w.y) / (w.z * w.z);
  return (std::sqrt(1 + alphaSquaredTowards(w) * tanSquared) - 1) / 2;
}

double Microfacets::maskingShadowing(const dvec3& wo, const dvec3& wi) const {
  return 1 / (1 + lambda(wo) + lambda(wi));
}

double Microfacets::normalPdf(const dvec3& wo, const dvec3& h) const {
  return distribution(h) * dot(wo, h) / (wo.z * (1 + lambda(wo)));
}

dvec3 Microfacets::sampleNormal(const dvec3& wo, const dvec2& u) const {
  const dvec3 stretch(alpha_, 1);
  const dvec3 onHemisphere = normalize(stretch * wo);
  const dvec3 onCap = sampleCap(u, 1 + onHemisphere.z);
  return normalize(stretch * (onHemisphere + onCap));
}

SingleScattering Microfacets::albedo(const dvec3& wo) const {
  return isIsotropic() ? isotropicAlbedo(wo.z) : anisotropicAlbedo(wo);
}

SingleScattering Microfacets::isotropicAlbedo(double cosine) const {
  const double alpha = alpha_.y;
  const TableAxis x(cosine * (1 + alpha) / (cosine + alpha), energy::kNodes), y(roughness_, energy::kNodes);
  const double white = interpolateIsotropic(energy::kWhite, x, y);
  const double tilted = std::max(0.0, 1 - cosine - alpha * interpolateIsotropic(energy::kTilt, x, y));
  return {white, white * std::pow(tilted, 5)};
}

AnisotropicCoordinates Microfacets::anisotropicCoordinates(const dvec3& wo) const {
  const double square = wo.x * wo.x + wo.y * wo.y;
  const double cosSquared = square > 0 ? wo.x * wo.x / square : 1;
  const double towards = std::sqrt(glm::mix(alpha_.y * alpha_.y, alpha_.x * alpha_.x, cosSquared));
  const double part = cosSquared * (alpha_.x + alpha_.y) / (towards + alpha_.y);
  return {anisotropy_, roughness_, std::sqrt(part), scaledCosine(wo.z, towards)};
}

SingleScattering Microfacets::anisotropicAlbedo(const dvec3& wo) const {
  AnisotropicCoordinates coordinates = anisotropicCoordinates(wo);
  const double white = std::min(1.0, interpolateAnisotropic(energy::kAnisotropicWhite, coordinates));
  coordinates[3] = scaledCosine(wo.z, alpha_.x);
  const double tilt = interpolateAnisotropic(energy::kAnisotropicTilt, coordinates);
  return {white, white * std::pow(std::clamp(1 - wo.z - alpha_.x * tilt, 0.0, 1.0), 5)};
}

}  // namespace candela::reference
