// The quantities that a device rounds. The tracers of this folder compute them exactly.
#pragma once
#include <cstdint>
#include <optional>

#include "host/trace/reference/bsdf.h"
#include "host/trace/reference/light.h"
#include "host/trace/reference/ray.h"
#include "host/trace/reference/surface.h"
#include "host/trace/reference/texture.h"
#include "host/trace/reference/tracing.h"

namespace candela::reference {

/// Exact arithmetic: every function returns the exact value of a quantity, and decisions are not recorded. The
/// arithmetic of a replica (host/trace/reference/rounding) adds the errors of single precision. The light transport is
/// the same for both. It passes each quantity through this class once, in the order of the computation.
class Arithmetic {
 public:
  virtual ~Arithmetic() = default;

  /// `originVaries`: the origin is computed, on a lens or on the plane of an orthographic camera.
  virtual Ray cameraRay(const Ray& ray, bool /*originVaries*/) { return ray; }
  /// Traces the ray to a vertex of a path, or to a node of a tree: docs/light-transport.md section 4. `ray` becomes the
  /// ray that was tested in effect.
  virtual Hit closest(const Tracing& tracing, std::uint32_t /*vertex*/, Ray& ray, Counters& counters) {
    return tracing.closest(ray, counters);
  }
  virtual bool isOccluded(const Tracing& tracing, const Ray& ray, const RayEnd& end, Counters& counters) {
    return tracing.isOccluded(ray, end, counters);
  }
  virtual Surface surfaceAt(const scene::Scene& scene, const Ray& ray, const Hit& hit) {
    return reference::surfaceAt(scene, ray, hit);
  }
  /// The coordinates (s, t) at which a texture is looked up; 0 without a texture.
  virtual dvec2 texCoords(const std::optional<scene::TextureReference>& texture, const MeshAttributes& attributes) {
    return texture ? textureCoordinates(*texture, attributes) : dvec2(0);
  }

  /// A unit vector that was turned into or out of a frame, or mirrored, or refracted.
  virtual dvec3 direction(const dvec3& direction) { return direction; }
  /// A direction for which an environment's map is looked up.
  virtual dvec3 mapDirection(const dvec3& direction) { return direction; }
  /// A direction by a warp (section 2), in the shading frame.
  virtual dvec3 sampledDirection(const dvec3& direction) { return direction; }
  /// A direction that microfacets of this alpha reflect or refract, in the shading frame.
  virtual dvec3 microfacetDirection(const dvec3& direction, double /*alpha*/) { return direction; }
  virtual dvec3 lightDirection(const dvec3& direction) { return direction; }
  virtual double lightDistance(double distance) { return distance; }
  virtual LightSample lightSample(const LightSample& light) { return light; }

  /// The importance of a node of a light tree, apart from cosines, and a cosine on which it depends. `condition`: of
  /// the map from the space of the tree to the scene.
  virtual double importance(double importance, double /*condition*/) { return importance; }
  virtual double cosineOfImportance(double cosine, double /*condition*/) { return cosine; }

  /// A random number that is compared with a probability.
  virtual double choice(double number) { return number; }
  /// The random number that is compared with the probabilities of a surface's lobes.
  virtual double lobeChoice(double number) { return number; }
  virtual double pdf(double pdf) { return pdf; }
  virtual BsdfValue bsdfValue(const BsdfValue& value, const Bsdf& /*bsdf*/) { return value; }
  virtual double reflectance(double reflectance) { return reflectance; }
  virtual dvec3 reflectance(const dvec3& reflectance) { return reflectance; }
  /// The factor by which a direction changes the throughput.
  virtual dvec3 throughput(const dvec3& factor) { return factor; }
  virtual double survival(double probability) { return probability; }
  virtual dvec3 radiance(const dvec3& radiance) { return radiance; }

  /// A decision, on which everything after it depends.
  virtual void decide(std::uint64_t /*choice*/) {}
  /// The decision that light arrives, with this cosine at the surface.
  virtual void decideLit(const dvec3& /*radiance*/, double /*cosine*/) {}
};

}  // namespace candela::reference
