// The kinds of light, which have the same interface: docs/light-transport.md section 6. Every kind has
//   sample(from, u)     a point of the light as seen from a surface; nothing if it does not illuminate the surface with
//                       these numbers
//   pdf(ray, distance, probability)  density per solid angle with which sample(), from the origin of `ray`, chooses
//                       the direction of the ray, which hits the light at `distance` or sees the background, times the
//                       probability of choosing this light; 0 if it is never sampled
//   intensity()         in the brightest direction, apart from a common factor; of lights that a tree can have
//   bounds(oneSided)    the node of the light tree, without its power; of the same lights
//   power()             weight of the light in the choice from the table; point lights and other lights have no common
//                       unit
#pragma once
#include <cstdint>
#include <optional>
#include <variant>

#include "host/trace/reference/geometry.h"
#include "host/trace/reference/light_bounds.h"
#include "host/trace/reference/light_margin.h"
#include "host/trace/reference/light_mesh.h"
#include "host/trace/reference/surface.h"

namespace candela::reference {

/// A point of a light as seen from a surface.
struct LightSample {
  dvec3 wi;
  double distance;
  dvec3 radiance;             ///< pi times the colour of a point light; the irradiance of a punctual light
  std::optional<double> pdf;  ///< per solid angle, given the choice of the light; none: a light that rays never hit
  std::uint32_t primitive;    ///< kNoPrimitive for a light that is not a primitive
  std::optional<dvec3>
      point{};            ///< the sampled point, or the position; none of a sphere or a light infinitely far away
  dvec2 barycentrics{0};  ///< of the point of a triangle, whose radiance is without its texture

  /// The end of the shadow ray.
  RayEnd end() const { return {distance, primitive, point}; }
};

/// Emits outwards and inwards; only inwards with a negative radius.
class SphereLight {
 public:
  SphereLight(const scene::Sphere& sphere, const dvec3& radiance, std::uint32_t primitive)
      : sphere_(sphere), radiance_(radiance), primitive_(primitive) {}

  std::optional<LightSample> sample(const Surface& from, const dvec2& u) const;
  double pdf(const Ray& ray, double distance, double probability) const;
  double power() const;
  double intensity() const { return power() / 4; }
  LightBounds bounds(bool oneSided) const;

 private:
  SphereShape sphere_;
  dvec3 radiance_;
  std::uint32_t primitive_;
};

/// Emits from both sides, or only from its front.
class TriangleLight {
 public:
  /// `meanTexel`: the mean of the texture of its emission.
  TriangleLight(const scene::Triangle& triangle, const dvec3& radiance, std::uint32_t primitive, bool oneSided,
                const dvec3& meanTexel = dvec3(1))
      : triangle_(triangle), radiance_(radiance), primitive_(primitive), oneSided_(oneSided), meanTexel_(meanTexel) {}

  std::optional<LightSample> sample(const Surface& from, const dvec2& u) const;
  double pdf(const Ray& ray, double distance, double probability) const;
  double power() const;
  double intensity() const { return power(); }
  LightBounds bounds(bool oneSided) const;
  double area() const { return length(triangle_.areaNormal()) / 2; }

 private:
  TriangleShape triangle_;
  dvec3 radiance_;
  std::uint32_t primitive_;
  bool oneSided_;
  dvec3 meanTexel_;
};

class PointLight {
 public:
  explicit PointLight(const scene::PointLight& light) : position_(light.position), colour_(light.colour) {}

  std::optional<LightSample> sample(const Surface& from, const dvec2& u) const;
  double pdf(const Ray&, double, double) const { return 0; }
  double power() const;
  double intensity() const { return 0; }
  LightBounds bounds(bool) const { return {}; }

 private:
  dvec3 position_;
  dvec3 colour_;
};

/// glTF's point, spot and directional lights.
class PunctualLight {
 public:
  explicit PunctualLight(const scene::PunctualLight& light);

  std::optional<LightSample> sample(const Surface& from, const dvec2& u) const;
  double pdf(const Ray&, double, double) const { return 0; }
  double power() const;
  double intensity() const { return power(); }
  LightBounds bounds(bool oneSided) const;
  /// Returns whether it is a point or spot light.
  bool hasPlace() const { return kind_ != scene::PunctualLight::Kind::directional; }

 private:
  scene::PunctualLight::Kind kind_;
  dvec3 position_;
  dvec3 direction_;
  dvec3 intensity_;
  double versineOuter_;  ///< 1 - cos of the outer angle
  double coneWidth_;     ///< difference of the cosines
  double reach_;
};

/// The entry of the environment. Its samples and densities need other numbers than those of the other kinds:
/// EnvironmentMap has them.
class EnvironmentLight {
 public:
  explicit EnvironmentLight(bool shines) : shines_(shines) {}

  std::optional<LightSample> sample(const Surface&, const dvec2&) const { return std::nullopt; }
  double pdf(const Ray&, double, double) const { return 0; }
  double power() const { return shines_ ? 1 : 0; }
  double intensity() const { return 0; }
  LightBounds bounds(bool) const { return {}; }

 private:
  bool shines_;
};

/// The entry of an instance that emits. One of its triangles is sampled.
class InstanceLight {
 public:
  /// `instance`: its index among all.
  InstanceLight(const LightInstance& light, std::uint32_t instance)
      : power_(light.power()), bounds_(light.bounds()), instance_(instance) {}

  std::optional<LightSample> sample(const Surface&, const dvec2&) const { return std::nullopt; }
  double pdf(const Ray&, double, double) const { return 0; }
  double power() const { return power_; }
  double intensity() const { return power_; }
  LightBounds bounds(bool) const { return bounds_; }
  std::uint32_t instance() const { return instance_; }

 private:
  double power_;
  LightBounds bounds_;
  std::uint32_t instance_;
};

/// Any kind of light.
using Light = std::variant<SphereLight, TriangleLight, PointLight, PunctualLight, EnvironmentLight, InstanceLight>;

}  // namespace candela::reference
