// Walter's refraction through microfacets, and mirrored reflection for thin walls.
#include "host/trace/reference/rough_glass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/scene/energy/anisotropic_tables.h"
#include "host/scene/energy/energy_tables.h"
#include "host/trace/reference/table_axis.h"

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

constexpr double kTransmissionMargin = 1.04;  // the estimate is less than that below what glass transmits

// Returns the energy that glass below a film scatters once; `bare` is that of the same glass without a film.
dvec3 albedoBelowFilm(const FilmOnGlass& film, double bare, const SingleScattering& single, double ior, bool outside) {
  double transmitting = bare;  // if it did not reflect
  if (outside) {
    const Reflectance schlick{dvec3(std::pow((ior - 1) / (ior + 1), 2)), dvec3(1)};
    const double reflected = schlick.albedo(single).x;
    transmitting = (bare - reflected) / (1 - reflected / single.white);
  }
  transmitting = std::min(1.0, kTransmissionMargin * transmitting);
  const dvec3 covered = film.reflectance * single.white + (1.0 - film.reflectance) * transmitting;
  return film.weight * covered + (1 - film.weight) * bare;
}

}  // namespace

RoughGlass::RoughGlass(const scene::SurfaceParameters& surface, const BaseReflectances& bases,
                       const Microfacets& microfacets, const dvec3& wo, bool outside, double weight)
    : microfacets_(microfacets),
      isThin_(surface.isThinWalled),
      dielectric_(bases.dielectricWeight * bases.dielectric),
      film_(bases.film),
      base_(surface.baseColour) {
  const double ior = std::max(double{surface.ior}, energy::kMinVolumeIor);
  if (!isThin_) (outside ? beyond_ : here_) = ior;
  const SingleScattering single = microfacets.albedo(wo);
  if (isThin_) {
    factor_ = dvec3(weight / single.white);
    return;
  }
  const double albedo = microfacets.isIsotropic()
                            ? glassAlbedo(microfacets, wo.z, ior, outside)
                            : anisotropicGlassAlbedo(microfacets.anisotropicCoordinates(wo), ior, outside);
  factor_ = film_ ? weight / albedoBelowFilm(*film_, albedo, single, ior, outside) : dvec3(weight / albedo);
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

dvec3 RoughGlass::kept(double cosine) const {
  const dvec3 f = schlick(cosine);
  if (!film_) return dvec3(largestOf(f));
  return f + film_->absorbed.at(outerCosine(cosine));
}

// The mean of the channels. Without a film, the channels are equal.
double RoughGlass::reflectionProbability(double cosine) const {
  const dvec3 k = kept(cosine);
  return film_ ? (k.x + k.y + k.z) / 3 : k.x;
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
  const double cosine = dot(wo, h);
  const dvec3 passing = 1.0 - kept(cosine);
  const double shape = microfacets_.distribution(h) * microfacets_.maskingShadowing(wo, mirrored);
  return {factor_ * passing * shape / (4 * wo.z * mirrored.z) * base_,
          (1 - reflectionProbability(cosine)) * microfacets_.normalPdf(wo, h) / (4 * cosine)};
}

BsdfValue RoughGlass::evaluateRefracted(const dvec3& wo, const dvec3& wi) const {
  dvec3 h = normalize(here_ * wo + beyond_ * wi);
  if (h.z < 0) h = -h;
  const double cosO = dot(wo, h), cosI = dot(wi, h);
  if (cosO <= 0 || cosI >= 0) return {};
  const dvec3 passing = 1.0 - kept(cosO);
  const double sum = here_ * cosO + beyond_ * cosI;
  const double solidAngle = beyond_ * beyond_ * -cosI / (sum * sum);  // of half vectors for that of directions
  const double g = microfacets_.maskingShadowing(wo, {wi.x, wi.y, -wi.z});
  const dvec3 f = passing * microfacets_.distribution(h) * g * cosO * solidAngle / (wo.z * -wi.z);
  return {factor_ * f * base_, (1 - reflectionProbability(cosO)) * microfacets_.normalPdf(wo, h) * solidAngle};
}

}  // namespace candela::reference
