// The kinds of light, which share one contract: docs/light-transport.md section 6. Every kind has
//   sample(from, u)     a lit point as seen from a surface; nothing where the light sends it no light by these numbers
//   pdf(ray, distance, probability)  density per solid angle with which sample(), from the origin of `ray`, finds what
//                       the ray finds, its hit on the light at `distance` or the background, times the probability of
//                       choosing this light; 0 where samples never find it
//   power()             weight of the light in the table's choice, without a common unit for point lights and the
//   others
#pragma once
#include <cstdint>
#include <optional>
#include <variant>

#include "host/reference/geometry.h"
#include "host/reference/surface.h"

namespace candela::reference {

/// A lit point as seen from a surface.
struct LightSample {
  dvec3 wi;
  double distance;
  dvec3 radiance;             ///< pi times the colour for a point light
  std::optional<double> pdf;  ///< per solid angle, given the choice; none: a point light, which only samples find
  std::uint32_t primitive;    ///< kNoPrimitive for a point light
};

/// Emits outwards and inwards; only inwards with a negative radius.
class SphereLight {
 public:
  SphereLight(const scene::Sphere& sphere, const dvec3& radiance, std::uint32_t primitive)
      : sphere_(sphere), radiance_(radiance), primitive_(primitive) {}

  std::optional<LightSample> sample(const Surface& from, const dvec2& u) const;
  double pdf(const Ray& ray, double distance, double probability) const;
  double power() const;

 private:
  SphereShape sphere_;
  dvec3 radiance_;
  std::uint32_t primitive_;
};

/// Emits from both sides, or from its front alone.
class TriangleLight {
 public:
  TriangleLight(const scene::Triangle& triangle, const dvec3& radiance, std::uint32_t primitive, bool oneSided)
      : triangle_(triangle), radiance_(radiance), primitive_(primitive), oneSided_(oneSided) {}

  std::optional<LightSample> sample(const Surface& from, const dvec2& u) const;
  double pdf(const Ray& ray, double distance, double probability) const;
  double power() const;
  double area() const { return length(triangle_.areaNormal()) / 2; }

 private:
  TriangleShape triangle_;
  dvec3 radiance_;
  std::uint32_t primitive_;
  bool oneSided_;
};

class PointLight {
 public:
  explicit PointLight(const scene::PointLight& light) : position_(light.position), colour_(light.colour) {}

  std::optional<LightSample> sample(const Surface& from, const dvec2& u) const;
  double pdf(const Ray&, double, double) const { return 0; }
  double power() const;

 private:
  dvec3 position_;
  dvec3 colour_;
};

/// What rays that miss everything find. No samples are taken of it, and a power of 0 keeps it out of the table.
class BackgroundLight {
 public:
  std::optional<LightSample> sample(const Surface&, const dvec2&) const { return std::nullopt; }
  double pdf(const Ray&, double, double) const { return 0; }
  double power() const { return 0; }
};

/// Any kind of light.
using Light = std::variant<SphereLight, TriangleLight, PointLight, BackgroundLight>;

}  // namespace candela::reference
