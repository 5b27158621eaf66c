// Quadrature over the visible normals, by spherical caps: Dupuy and Benyoub, "Sampling Visible GGX Normals with
// Spherical Caps", 2023. Loops read plain arrays, so that compilers vectorise them.
#include "host/scene/energy/anisotropic_albedo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::energy {
namespace {

using glm::vec2;
using glm::vec3;

float fifthPower(float x) { return x * x * (x * x) * x; }

// Smith's masking and shadowing for a view.
struct Masking {
  vec2 alpha;
  float cosine;  // of wo
  float length;  // of wo stretched by alpha

  // Returns G2 / G1 of a direction, the weight of a sample; 0 below the horizon.
  float weightOf(float x, float y, float z) const {
    const float across = alpha.x * x, along = alpha.y * y;
    const float other = std::sqrt(across * across + along * along + z * z);
    const float weight = z * (cosine + length) / (z * length + cosine * other);
    return z > 0 ? weight : 0;
  }
};

}  // namespace

Lattice::Lattice(std::size_t points, std::size_t step) {
  const auto count = static_cast<double>(points);
  for (std::size_t i = 0; i < points; ++i) {
    const double azimuth = 2 * std::numbers::pi * static_cast<double>(i * step % points) / count;
    heights.push_back(static_cast<float>((static_cast<double>(i) + 0.5) / count));
    cosines.push_back(static_cast<float>(std::cos(azimuth)));
    sines.push_back(static_cast<float>(std::sin(azimuth)));
  }
}

VisibleNormals::VisibleNormals(double cosine, double cosSquared, const glm::dvec2& alpha, const Lattice& lattice)
    : alpha_(alpha), x_(lattice.size()), y_(x_), z_(x_), cosines_(x_), reflected_(x_) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  wo_ = vec3(sine * std::sqrt(cosSquared), sine * std::sqrt(std::max(0.0, 1 - cosSquared)), cosine);
  length_ = length(vec3(alpha_, 1) * wo_);
  addNormals(lattice);
  addReflected();
}

void VisibleNormals::addNormals(const Lattice& lattice) {
  const vec3 seen = vec3(alpha_, 1) * wo_ / length_;
  const vec2 alpha = alpha_;
  const float *heights = lattice.heights.data(), *cosines = lattice.cosines.data(), *sines = lattice.sines.data();
  float *xs = x_.data(), *ys = y_.data(), *zs = z_.data();
#pragma omp simd
  for (std::size_t i = 0; i < size(); ++i) {
    const float height = 1 - heights[i] * (1 + seen.z);
    const float radius = std::sqrt(std::max(0.0f, 1 - height * height));
    const float x = alpha.x * (radius * cosines[i] + seen.x);
    const float y = alpha.y * (radius * sines[i] + seen.y);
    const float z = height + seen.z;
    const float scale = 1 / std::sqrt(x * x + y * y + z * z);
    xs[i] = scale * x;
    ys[i] = scale * y;
    zs[i] = scale * z;
  }
}

void VisibleNormals::addReflected() {
  const Masking masking{alpha_, wo_.z, length_};
  const vec3 wo = wo_;
  const float *xs = x_.data(), *ys = y_.data(), *zs = z_.data();
  float *cosines = cosines_.data(), *reflected = reflected_.data();
#pragma omp simd
  for (std::size_t i = 0; i < size(); ++i) {
    const float cosine = wo.x * xs[i] + wo.y * ys[i] + wo.z * zs[i], twice = 2 * cosine;
    cosines[i] = cosine < 1 ? cosine : 1;
    reflected[i] = masking.weightOf(twice * xs[i] - wo.x, twice * ys[i] - wo.y, twice * zs[i] - wo.z);
  }
}

MicrofacetAlbedo VisibleNormals::albedo() const {
  const float *cosines = cosines_.data(), *reflected = reflected_.data();
  float white = 0, grazing = 0;
#pragma omp simd reduction(+ : white, grazing)
  for (std::size_t i = 0; i < size(); ++i) {
    white += reflected[i];
    grazing += reflected[i] * fifthPower(1 - cosines[i]);
  }
  const auto count = static_cast<double>(size());
  return {double{white} / count, double{grazing} / count};
}

void VisibleNormals::integrateGlass(const Boundaries<float>& boundaries, std::span<double> albedos) const {
  const Masking masking{alpha_, wo_.z, length_};
  const vec3 wo = wo_;
  const float *xs = x_.data(), *ys = y_.data(), *zs = z_.data(), *cosines = cosines_.data();
  const float* reflected = reflected_.data();
  for (std::size_t b = 0; b < boundaries.size(); ++b) {
    const float eta = boundaries.eta[b], normal = boundaries.normalReflectance[b];
    float sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < size(); ++i) {
      const float cosSquared = 1 - eta * eta * (1 - cosines[i] * cosines[i]);  // of the refracted direction
      const float refracted = std::sqrt(std::max(0.0f, cosSquared));
      const float schlick = normal + (1 - normal) * fifthPower(1 - (eta < 1 ? cosines[i] : refracted));
      const float reflectance = cosSquared <= 0 ? 1 : schlick;
      const float part = eta * cosines[i] - refracted;  // of the normal in the opposite of the refracted direction
      const float transmitted = masking.weightOf(eta * wo.x - part * xs[i], eta * wo.y - part * ys[i],
                                                 eta * wo.z - part * zs[i]);
      sum += reflectance * reflected[i] + (1 - reflectance) * transmitted;
    }
    albedos[b] = double{sum} / static_cast<double>(size());
  }
}

}  // namespace candela::energy
