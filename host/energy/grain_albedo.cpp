// Quadrature over the visible normals, by spherical caps: Dupuy and Benyoub, "Sampling Visible GGX Normals with
// Spherical Caps", 2023.
#include "host/energy/grain_albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace candela::energy {
namespace {

using glm::dvec2;
using glm::dvec3;

// Two successive Fibonacci numbers.
constexpr std::size_t kPoints = 2584, kStep = 1597;

using Directions = std::array<dvec2, kPoints>;

// Returns cosine and sine of the azimuths of the lattice's points.
Directions azimuths() {
  Directions directions;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double turns = static_cast<double>(i * kStep % kPoints) / kPoints;
    directions[i] = {std::cos(2 * std::numbers::pi * turns), std::sin(2 * std::numbers::pi * turns)};
  }
  return directions;
}

}  // namespace

MicrofacetAlbedo integrateGrain(double cosine, double cosSquared, const dvec2& alpha) {
  static const Directions kAzimuths = azimuths();
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const dvec3 wo(sine * std::sqrt(cosSquared), sine * std::sqrt(std::max(0.0, 1 - cosSquared)), cosine);
  const dvec3 stretch(alpha, 1);
  const double out = length(stretch * wo);
  const dvec3 seen = stretch * wo / out;
  MicrofacetAlbedo sum{0, 0};
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double z = 1 - (static_cast<double>(i) + 0.5) / kPoints * (1 + seen.z);
    const double radius = std::sqrt(std::max(0.0, 1 - z * z));
    const dvec3 h = normalize(stretch * (dvec3(radius * kAzimuths[i], z) + seen));
    const double cosH = dot(wo, h);
    const dvec3 wi = 2 * cosH * h - wo;
    if (wi.z <= 0) continue;
    const double weight = wi.z * (cosine + out) / (wi.z * out + cosine * length(stretch * wi));  // G2 / G1
    sum.white += weight;
    sum.grazing += weight * std::pow(1 - cosH, 5);
  }
  return {sum.white / kPoints, sum.grazing / kPoints};
}

}  // namespace candela::energy
