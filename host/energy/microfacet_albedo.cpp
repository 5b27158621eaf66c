// Quadrature over the visible normals.
#include "host/energy/microfacet_albedo.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

namespace candela::energy {
namespace {

using glm::dvec2;
using glm::dvec3;

// Returns the cosine and the sine of the azimuth of a spoke. By symmetry, half of the circle suffices.
dvec2 azimuthOf(int spoke, int spokes) {
  const double azimuth = std::numbers::pi * (spoke + 0.5) / spokes;
  return {std::cos(azimuth), std::sin(azimuth)};
}

// Returns a visible normal by spherical caps: Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps",
// 2023.
dvec3 visibleNormal(const dvec3& wo, double alpha, double fraction, const dvec2& azimuth) {
  const dvec3 stretched = normalize(dvec3(alpha * wo.x, alpha * wo.y, wo.z));
  const double z = 1 - fraction * (1 + stretched.z);
  const double radius = std::sqrt(std::max(0.0, 1 - z * z));
  const dvec3 half = dvec3(radius * azimuth, z) + stretched;
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

double fifthPower(double x) { return x * x * (x * x) * x; }

// One side of a boundary between dielectrics.
struct Boundary {
  double eta;  ///< index of refraction on the side of wo divided by the other
  double normalReflectance;

  // Returns the cosine of the refracted direction; 0 if the reflection is total.
  double refractedCosine(double cosine) const {
    return std::sqrt(std::max(0.0, 1 - eta * eta * (1 - cosine * cosine)));
  }
  double reflectance(double cosine) const {
    const double refracted = refractedCosine(cosine);
    if (refracted == 0) return 1;
    return std::lerp(normalReflectance, 1, fifthPower(1 - (eta < 1 ? cosine : refracted)));
  }
};

double glassWeightOf(const dvec3& wo, const dvec3& h, double alpha, const Boundary& boundary) {
  const double cosine = dot(wo, h), refracted = boundary.refractedCosine(cosine);
  const double reflectance = boundary.reflectance(cosine);
  const dvec3 below = boundary.eta * wo - (boundary.eta * cosine - refracted) * h;  // the opposite of the direction
  return reflectance * weightOf(wo, 2 * cosine * h - wo, alpha) + (1 - reflectance) * weightOf(wo, below, alpha);
}

}  // namespace

double integrateGlass(double cosine, double alpha, double ior, bool outside, int rings, int spokes) {
  const dvec3 wo(std::sqrt(std::max(0.0, 1 - cosine * cosine)), 0, cosine);
  const Boundary boundary{outside ? 1 / ior : ior, std::pow((ior - 1) / (ior + 1), 2)};
  double sum = 0;
  for (int spoke = 0; spoke < spokes; ++spoke) {
    const dvec2 azimuth = azimuthOf(spoke, spokes);
    for (int ring = 0; ring < rings; ++ring) {
      sum += glassWeightOf(wo, visibleNormal(wo, alpha, (ring + 0.5) / rings, azimuth), alpha, boundary);
    }
  }
  return sum / (double{1} * rings * spokes);
}

MicrofacetAlbedo integrateMicrofacets(double cosine, double alpha, int rings, int spokes) {
  const dvec3 wo(std::sqrt(std::max(0.0, 1 - cosine * cosine)), 0, cosine);
  MicrofacetAlbedo sum{0, 0};
  for (int spoke = 0; spoke < spokes; ++spoke) {
    const dvec2 azimuth = azimuthOf(spoke, spokes);
    for (int ring = 0; ring < rings; ++ring) {
      const dvec3 h = visibleNormal(wo, alpha, (ring + 0.5) / rings, azimuth);
      const double weight = weightOf(wo, 2 * dot(wo, h) * h - wo, alpha);
      sum.white += weight;
      sum.grazing += weight * fifthPower(1 - dot(wo, h));
    }
  }
  const double count = double{1} * rings * spokes;
  return {sum.white / count, sum.grazing / count};
}

}  // namespace candela::energy
