// Walter's refraction through microfacets, and mirrored reflection for thin walls.
#include "host/reference/rough_glass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/energy/anisotropic_tables.h"
#include "host/energy/energy_tables.h"
#include "host/reference/table_axis.h"

namespace candela::reference {
namespace {

// Returns the energy that glass which bounds a volume scatters once.
double glassAlbedo(const Microfacets& microfacets, double cosine, double ior, bool outside) {
  const double alpha = microfacets.alpha();
  const std::array fractions{2 * (ior - 1) / (ior + 1), std::sqrt(alpha), cosine * (1 + alpha) / (cosine + alpha)};
  const energy::GlassTable& table = outside ? energy::kGlassOutside : energy::kGlassInside;
  return interpolateTable<3>(table.data(), fractions,
                             {energy::kGlassIors, energy::kGlassRoughnesses, energy::kGlassCosines});
}

double anisotropicGlassAlbedo(const AnisotropicCoordinates& coordinates, double ior, bool outside) {
  const std::array fractions{std::sqrt(2 * (ior - 1) / (ior + 1)), coordinates[0], coordinates[1], coordinates[2],
                             coordinates[3]};
  constexpr std::array kSizes{energy::kAnisotropicGlassIors, energy::kAnisotropicGlassStrengths,
                              energy::kAnisotropicGlassRoughnesses, energy::kAnisotropicGlassAzimuths,
                              energy::kAnisotropicGlassCosines};
  const energy::AnisotropicGlassTable& table = outside ? energy::kAnisotropicGlassOutside
                                                       : energy::kAnisotropicGlassInside;
  return std::min(1.0, interpolateTable(table.data(), fractions, kSizes));
}

}  // namespace

RoughGlass::RoughGlass(const scene::SurfaceParameters& surface, const Reflectance& dielectric,
                       const Microfacets& microfacets, const dvec3& wo, bool outside, double weight)
    : microfacets_(microfacets), isThin_(surface.isThinWalled), dielectric_(dielectric), base_(surface.baseColour) {
  const double ior = std::max(double{surface.ior}, energy::kMinVolumeIor);
  if (!isThin_) (outside ? beyond_ : here_) = ior;
  if (isThin_)
    factor_ = weight / microfacets.albedo(wo).white;
  else if (microfacets.isIsotropic())
    factor_ = weight / glassAlbedo(microfacets, wo.z, ior, outside);
  else
    factor_ = weight / anisotropicGlassAlbedo(microfacets.anisotropicCoordinates(wo), ior, outside);
}

double RoughGlass::outerCosine(double cosine) const {
  if (here_ <= beyond_) return cosine;
  const double sine = here_ / beyond_ * std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return sine >= 1 ? 0 : std::sqrt(1 - sine * sine);
}

dvec3 RoughGlass::schlick(double cosine) const {
  const double outer = outerCosine(cosine);
  if (here_ > beyond_ && outer == 0) return dvec3(1);
  return dielectric_.at(outer);
}

dvec3 RoughGlass::reflectance(double cosine) const { return factor_ * schlick(cosine); }

double RoughGlass::strongest(double cosine) const {
  const dvec3 f = schlick(cosine);
  return std::max({f.x, f.y, f.z});
}

dvec3 RoughGlass::transmit(const dvec3& wo, const dvec3& h) const {
  const dvec3 reflected = 2 * dot(wo, h) * h - wo;
  if (isThin_) return {reflected.x, reflected.y, -reflected.z};
  const double cosine = dot(wo, h), ratio = here_ / beyond_;
  const dvec3 along = ratio * (cosine * h - wo);  // the part of the direction in the microfacet's plane
  return along - std::sqrt(std::max(0.0, 1 - dot(along, along))) * h;
}

BsdfValue RoughGlass::evaluate(const dvec3& wo, const dvec3& wi) const {
  return isThin_ ? evaluateThin(wo, wi) : evaluateRefracted(wo, wi);
}

BsdfValue RoughGlass::evaluateThin(const dvec3& wo, const dvec3& wi) const {
  const dvec3 mirrored(wi.x, wi.y, -wi.z);
  const dvec3 h = normalize(wo + mirrored);
  const double passing = 1 - strongest(dot(wo, h));
  const double shape = microfacets_.distribution(h) * microfacets_.maskingShadowing(wo, mirrored);
  return {factor_ * passing * shape / (4 * wo.z * mirrored.z) * base_,
          passing * microfacets_.normalPdf(wo, h) / (4 * dot(wo, h))};
}

BsdfValue RoughGlass::evaluateRefracted(const dvec3& wo, const dvec3& wi) const {
  dvec3 h = normalize(here_ * wo + beyond_ * wi);
  if (h.z < 0) h = -h;
  const double cosO = dot(wo, h), cosI = dot(wi, h);
  if (cosO <= 0 || cosI >= 0) return {};
  const double passing = 1 - strongest(cosO);
  const double sum = here_ * cosO + beyond_ * cosI;
  const double solidAngle = beyond_ * beyond_ * -cosI / (sum * sum);  // of half vectors for that of directions
  const double g = microfacets_.maskingShadowing(wo, {wi.x, wi.y, -wi.z});
  const double f = passing * microfacets_.distribution(h) * g * cosO * solidAngle / (wo.z * -wi.z);
  return {factor_ * f * base_, passing * microfacets_.normalPdf(wo, h) * solidAngle};
}

}  // namespace candela::reference
