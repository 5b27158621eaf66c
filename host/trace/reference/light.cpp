// Samples spheres by solid angle and triangles by area.
#include "host/trace/reference/light.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/image/film.h"
#include "host/trace/reference/sampling.h"

namespace candela::reference {
namespace {

// Sampling of a sphere from `point`: the cap of directions that hit it, or all directions.
struct SphereView {
  bool wholeSphere;
  double capHeight;

  SphereView(const SphereShape& sphere, const dvec3& point, bool startsHere) {
    const dvec3 toCentre = sphere.centre - point;
    const double sinSquared = sphere.radius * sphere.radius / dot(toCentre, toCentre);
    wholeSphere = startsHere || !(sinSquared < 1);
    capHeight = wholeSphere ? 2 : sinSquared / (1 + std::sqrt(1 - sinSquared));  // 1 - cos, without cancellation
  }
};

}  // namespace

std::optional<LightSample> SphereLight::sample(const Surface& from, const dvec2& u) const {
  const bool startsHere = from.primitive == primitive_;
  const SphereView view(sphere_, from.position, startsHere);
  const dvec3 local = sampleCap(u, view.capHeight);
  const dvec3 wi = view.wholeSphere ? local : Frame(normalize(sphere_.centre - from.position)).toWorld(local);
  const double distance = sphere_.distance({from.position, wi}, startsHere);
  if (distance == kNoHit) return std::nullopt;
  return LightSample{wi, distance, radiance_, capPdf(view.capHeight), primitive_, std::nullopt};
}

double SphereLight::pdf(const Ray& ray, double, double probability) const {
  return probability * capPdf(SphereView(sphere_, ray.origin, ray.originPrimitive == primitive_).capHeight);
}

double SphereLight::power() const { return 4 * kPi * sphere_.radius * sphere_.radius * image::luminance(radiance_); }

LightBounds SphereLight::bounds(bool) const {
  return boundsOfSphere(glm::vec3(sphere_.centre), static_cast<float>(sphere_.radius));
}

std::optional<LightSample> TriangleLight::sample(const Surface& from, const dvec2& u) const {
  if (from.primitive == primitive_) return std::nullopt;
  const dvec2 b = sampleTriangle(u);
  const dvec3 point = triangle_.corner + b.x * triangle_.edge1 + b.y * triangle_.edge2;
  const dvec3 toLight = point - from.position;
  const double distance = length(toLight);
  if (distance == 0) return std::nullopt;
  const dvec3 wi = toLight / distance;
  // Twice the area times the cosine; > 0 on the back.
  const double projected = dot(wi, triangle_.areaNormal());
  if (projected == 0 || (oneSided_ && projected > 0)) return std::nullopt;
  const double pdf = 2 * distance * distance / std::abs(projected);
  return LightSample{wi, distance, radiance_, pdf, primitive_, point, b};
}

double TriangleLight::pdf(const Ray& ray, double distance, double probability) const {
  return probability * 2 * distance * distance / std::abs(dot(ray.direction, triangle_.areaNormal()));
}

double TriangleLight::power() const { return area() * image::luminance(radiance_ * meanTexel_); }

LightBounds TriangleLight::bounds(bool oneSided) const {
  return boundsOfTriangle({triangle_.corner, triangle_.corner1, triangle_.corner2}, !oneSided);
}

std::optional<LightSample> PointLight::sample(const Surface& from, const dvec2&) const {
  const dvec3 toLight = position_ - from.position;
  const double distance = length(toLight);
  if (distance == 0) return std::nullopt;
  return LightSample{toLight / distance, distance, kPi * colour_, std::nullopt, kNoPrimitive, position_};
}

double PointLight::power() const { return image::luminance(colour_); }

PunctualLight::PunctualLight(const scene::PunctualLight& light)
    : kind_(light.kind),
      position_(light.position),
      direction_(light.direction),
      intensity_(light.intensity),
      versineOuter_(light.versineOuter),
      coneWidth_(double{light.versineOuter} - double{light.versineInner}),
      reach_(light.reach) {}

std::optional<LightSample> PunctualLight::sample(const Surface& from, const dvec2&) const {
  using Kind = scene::PunctualLight::Kind;
  if (kind_ == Kind::directional) {
    constexpr double kFar = std::numeric_limits<float>::max();
    return LightSample{-direction_, kFar, intensity_, std::nullopt, kNoPrimitive, std::nullopt};
  }
  const dvec3 fromLight = from.position - position_;
  const double distance = length(fromLight);
  if (distance == 0) return std::nullopt;
  const dvec3 away = fromLight / distance;
  dvec3 irradiance = intensity_ / (distance * distance);
  if (kind_ == Kind::spot) {
    const double cosine = dot(away, normalize(direction_));  // the scene's direction is a unit vector to 2^-24 only
    const double inside = std::clamp((cosine - 1 + versineOuter_) / coneWidth_, 0.0, 1.0);
    irradiance *= inside * inside;
  }
  if (irradiance == dvec3(0)) return std::nullopt;
  return LightSample{-away, distance, irradiance, std::nullopt, kNoPrimitive, position_};
}

LightBounds PunctualLight::bounds(bool) const {
  const glm::vec3 position(position_);
  if (kind_ == scene::PunctualLight::Kind::point) return boundsOfPoint(position);
  return boundsOfSpot(position, direction_, 1 - versineOuter_);
}

double PunctualLight::power() const {
  const double luminance = image::luminance(intensity_);
  return kind_ == scene::PunctualLight::Kind::directional ? luminance * reach_ * reach_ : luminance;
}

}  // namespace candela::reference
