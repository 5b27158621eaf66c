// Quadrature over the visible normals. The order of additions is that of rings within spokes, so that the tables do not
// depend on how much of it is vectorised.
#include "host/scene/energy/microfacet_albedo.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

namespace candela::energy {
namespace {

using glm::dvec2;
using glm::dvec3;

// Returns the cosine and the sine of the azimuth of a spoke. By symmetry, half of the circle suffices.
dvec2 azimuthOf(int spoke, int spokes) {
  const double azimuth = std::numbers::pi * (spoke + 0.5) / spokes;
  return {std::cos(azimuth), std::sin(azimuth)};
}

double fifthPower(double x) { return x * x * (x * x) * x; }

// A rough surface seen from wo: its visible normals and their weights.
class View {
 public:
  View(double cosine, double alpha)
      : alpha_(alpha),
        wo_(std::sqrt(std::max(0.0, 1 - cosine * cosine)), 0, cosine),
        stretched_(normalize(dvec3(alpha * wo_.x, alpha * wo_.y, wo_.z))),
        length_(stretchedLength(wo_)) {}

  const dvec3& wo() const { return wo_; }

  // Returns a visible normal by spherical caps: Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps",
  // 2023.
  dvec3 visibleNormal(double fraction, const dvec2& azimuth) const {
    const double z = 1 - fraction * (1 + stretched_.z);
    const double radius = std::sqrt(std::max(0.0, 1 - z * z));
    const dvec3 half = dvec3(radius * azimuth, z) + stretched_;
    return normalize(dvec3(alpha_ * half.x, alpha_ * half.y, half.z));
  }

  // Returns G2 / G1 of the reflected direction, the weight of a sample; 0 below the horizon.
  double weightOf(const dvec3& wi) const {
    const double weight = wi.z * (wo_.z + length_) / (wi.z * length_ + wo_.z * stretchedLength(wi));
    return wi.z <= 0 ? 0 : weight;
  }

 private:
  // Returns the length of w stretched by alpha; Smith's Lambda is (length / cosine - 1) / 2.
  double stretchedLength(const dvec3& w) const {
    return std::sqrt(alpha_ * alpha_ * (w.x * w.x + w.y * w.y) + w.z * w.z);
  }

  double alpha_;
  dvec3 wo_;
  dvec3 stretched_;
  double length_;
};

// Adds the light that one normal scatters, for every boundary.
void addGlass(const View& view, const dvec3& h, const Boundaries<double>& boundaries, double* sums) {
  const dvec3 wo = view.wo();
  const double cosine = dot(wo, h), reflected = view.weightOf(2 * cosine * h - wo);
  const double* etas = boundaries.eta.data();
  const double* normals = boundaries.normalReflectance.data();
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    const double eta = etas[i], normal = normals[i];
    const double refracted = std::sqrt(std::max(0.0, 1 - eta * eta * (1 - cosine * cosine)));
    const double fifth = fifthPower(1 - (eta < 1 ? cosine : refracted));
    const double reflectance = refracted == 0 ? 1 : std::min(1.0, normal + fifth * (1 - normal));
    const dvec3 below = eta * wo - (eta * cosine - refracted) * h;  // the opposite of the direction
    sums[i] += reflectance * reflected + (1 - reflectance) * view.weightOf(below);
  }
}

}  // namespace

void integrateGlass(double cosine, double alpha, const Boundaries<double>& boundaries, std::span<double> albedos,
                    int rings, int spokes) {
  const View view(cosine, alpha);
  std::ranges::fill(albedos, 0);
  for (int spoke = 0; spoke < spokes; ++spoke) {
    const dvec2 azimuth = azimuthOf(spoke, spokes);
    for (int ring = 0; ring < rings; ++ring) {
      addGlass(view, view.visibleNormal((ring + 0.5) / rings, azimuth), boundaries, albedos.data());
    }
  }
  for (double& albedo : albedos) albedo /= double{1} * rings * spokes;
}

MicrofacetAlbedo integrateMicrofacets(double cosine, double alpha, int rings, int spokes) {
  const View view(cosine, alpha);
  std::vector<double> white(static_cast<std::size_t>(rings)), grazing(white.size());
  MicrofacetAlbedo sum{0, 0};
  for (int spoke = 0; spoke < spokes; ++spoke) {
    const dvec2 azimuth = azimuthOf(spoke, spokes);
    for (int ring = 0; ring < rings; ++ring) {
      const dvec3 h = view.visibleNormal((ring + 0.5) / rings, azimuth);
      const double cosH = dot(view.wo(), h), weight = view.weightOf(2 * cosH * h - view.wo());
      const auto i = static_cast<std::size_t>(ring);
      white[i] = weight;
      grazing[i] = weight * fifthPower(1 - cosH);
    }
    for (const double weight : white) sum.white += weight;
    for (const double weight : grazing) sum.grazing += weight;
  }
  const double count = double{1} * rings * spokes;
  return {sum.white / count, sum.grazing / count};
}

}  // namespace candela::energy
