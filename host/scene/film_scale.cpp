// Chooses the scale of a film from the lights of a scene.
#include "host/scene/film_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/scene/bounds.h"

namespace candela::scene {
namespace {

constexpr double kMaxPlainIrradiance = 64;  ///< highlights of roughness 0.05 are then below kFilmMaximum
constexpr int kRadianceBits = 17;           ///< a strong radiance is brought to at most 2^17

double largestChannel(const glm::vec3& colour) { return std::max({colour.x, colour.y, colour.z}); }

// The square of half the diagonal of the scene; 1 if it has no extent.
double squaredRadius(const Scene& scene) {
  const std::optional<Bounds> bounds = boundsOf(scene);
  if (!bounds) return 1;
  const glm::dvec3 diagonal = glm::dvec3(bounds->max) - glm::dvec3(bounds->min);
  const double squared = glm::dot(diagonal, diagonal) / 4;
  return squared > 0 ? squared : 1;
}

// The irradiance by lights without extent, at the distance of half the scene's diagonal where they fall off.
double irradianceOf(const Scene& scene) {
  double constant = 0, falling = 0;
  for (const PointLight& light : scene.pointLights) constant += std::numbers::pi * largestChannel(light.colour);
  for (const PunctualLight& light : scene.punctualLights) {
    (light.kind == PunctualLight::Kind::directional ? constant : falling) += largestChannel(light.intensity);
  }
  return falling > 0 ? constant + falling / squaredRadius(scene) : constant;
}

double radianceOf(const Scene& scene) {
  double largest = scene.environment ? 0 : largestChannel(scene.background);
  for (const Material& material : scene.materials) largest = std::max(largest, largestChannel(material.emission));
  if (!scene.environment) return largest;
  for (const glm::vec3& texel : scene.environment->texels) largest = std::max(largest, largestChannel(texel));
  return largest;
}

// Returns the logarithm to base 2 of a positive number, rounded up. Unlike std::log2, this is exact.
int ceilLog2(double value) {
  int exponent = 0;
  const double finite = std::min(value, std::numeric_limits<double>::max());
  const double fraction = std::frexp(finite, &exponent);  // in [0.5, 1)
  return fraction == 0.5 ? exponent - 1 : exponent;
}

}  // namespace

std::uint32_t filmScaleOf(const Scene& scene) {
  const double irradiance = irradianceOf(scene), radiance = radianceOf(scene);
  int scale = 0;
  if (irradiance > kMaxPlainIrradiance) scale = ceilLog2(irradiance);
  if (radiance > image::kFilmMaximum) scale = std::max(scale, ceilLog2(radiance) - kRadianceBits);
  return std::min(static_cast<std::uint32_t>(scale), image::kMaxFilmScale);
}

}  // namespace candela::scene
