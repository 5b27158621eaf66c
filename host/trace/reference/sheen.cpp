// The "Charlie" distribution, with the fit of Conty Estevez and Kulla for its masking.
#include "host/trace/reference/sheen.h"

#include <algorithm>
#include <cmath>

#include "host/scene/energy/energy_tables.h"
#include "host/trace/reference/sampling.h"
#include "host/trace/reference/table_axis.h"

namespace candela::reference {
namespace {

double boundedCosine(double cosine) { return std::clamp(cosine, 0.001, 1.0); }

double boundedRoughness(const scene::SurfaceParameters& surface) {
  return std::max(double{surface.sheenRoughness}, double{static_cast<float>(energy::kMinSheenRoughness)});
}

// Below a weight of 1, the factor that bounds the albedo.
double weightOf(double roughness) { return roughness / (0.198 + 0.24 * roughness); }

// Returns the albedo times weightOf().
double weighedAlbedo(double cosine, double roughness) {
  const TableAxis x(std::sqrt(cosine * (1 + roughness) / (cosine + roughness)), energy::kSheenCosines);
  const TableAxis y(roughness, energy::kSheenRoughnesses);
  const auto along = [&](std::size_t j) {
    const float* at = energy::kSheen.data() + j * energy::kSheenCosines + x.node;
    return std::lerp(double{at[0]}, double{at[1]}, x.part);
  };
  return std::lerp(along(y.node), along(y.node + 1), y.part);
}

}  // namespace

Sheen::Sheen(const scene::SurfaceParameters& surface, const dvec3& wo) : colour_(surface.sheenColour) {
  const double roughness = boundedRoughness(surface), weight = weightOf(roughness);
  alpha_ = roughness * roughness;
  factor_ = std::min(1.0, weight);
  if (exists()) white_ = factor_ / weight * weighedAlbedo(wo.z, roughness);
}

dvec3 Sheen::value(const dvec3& wo, const dvec3& wi) const {
  const dvec3 v = wo + wi;
  const double sinSquared = (v.x * v.x + v.y * v.y) / dot(v, v);
  const double distribution = factor_ * (2 + 1 / alpha_) / (2 * kPi) * std::pow(sinSquared, 0.5 / alpha_);
  const double masking = 1 / (1 + lambda(wo.z) + lambda(wi.z));
  return distribution * masking / (4 * boundedCosine(wo.z) * boundedCosine(wi.z)) * colour_;
}

double Sheen::takenFraction() const { return white_ * std::max({colour_.x, colour_.y, colour_.z}); }

double Sheen::lambda(double cosine) const {
  const double c = boundedCosine(cosine);
  return c < 0.5 ? std::exp(fit(c)) : std::exp(2 * fit(0.5) - fit(std::max(1 - c, 1e-9)));
}

double Sheen::fit(double x) const {
  const double smooth = std::pow(1 - alpha_, 2);
  const auto mixed = [&](double rough, double flat) { return std::lerp(rough, flat, smooth); };
  const double power = std::pow(x, mixed(0.19823, 0.16801));
  return mixed(21.5473, 25.3245) / (1 + mixed(3.82987, 3.32435) * power) + mixed(-1.97760, -1.27393) * x +
         mixed(-4.32054, -4.85967);
}

}  // namespace candela::reference
