// Quadrature over the visible normals.
#include "host/energy/microfacet_albedo.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

namespace candela::energy {
namespace {

using glm::dvec3;

// Returns a visible normal by spherical caps: Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps",
// 2023.
dvec3 visibleNormal(const dvec3& wo, double alpha, double fraction, double azimuth) {
  const dvec3 stretched = normalize(dvec3(alpha * wo.x, alpha * wo.y, wo.z));
  const double z = 1 - fraction * (1 + stretched.z);
  const double radius = std::sqrt(std::max(0.0, 1 - z * z));
  const dvec3 half = dvec3(radius * std::cos(azimuth), radius * std::sin(azimuth), z) + stretched;
  return normalize(dvec3(alpha * half.x, alpha * half.y, half.z));
}

// Returns the length of w stretched by alpha; Smith's Lambda is (length / cosine - 1) / 2.
double stretchedLength(const dvec3& w, double alpha) {
  return std::sqrt(alpha * alpha * (w.x * w.x + w.y * w.y) + w.z * w.z);
}

// Returns G2 / G1 of the reflected direction, the weight of a sample; 0 below the horizon.
double weightOf(const dvec3& wo, const dvec3& wi, double alpha) {
  if (wi.z <= 0) return 0;
  const double out = stretchedLength(wo, alpha);
  return wi.z * (wo.z + out) / (wi.z * out + wo.z * stretchedLength(wi, alpha));
}

}  // namespace

MicrofacetAlbedo integrateMicrofacets(double cosine, double alpha, int rings, int spokes) {
  const dvec3 wo(std::sqrt(std::max(0.0, 1 - cosine * cosine)), 0, cosine);
  MicrofacetAlbedo sum{0, 0};
  for (int ring = 0; ring < rings; ++ring) {
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const dvec3 h = visibleNormal(wo, alpha, (ring + 0.5) / rings, std::numbers::pi * (spoke + 0.5) / spokes);
      const double weight = weightOf(wo, 2 * dot(wo, h) * h - wo, alpha);
      sum.white += weight;
      sum.grazing += weight * std::pow(1 - dot(wo, h), 5);
    }
  }
  const double count = double{1} * rings * spokes;
  return {sum.white / count, sum.grazing / count};
}

}  // namespace candela::energy
