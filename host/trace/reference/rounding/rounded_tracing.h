// Intersection tests with the errors of single precision.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/trace/reference/texture.h"
#include "host/trace/reference/tracing.h"

namespace candela::reference {

/// The random errors in the tests of one ray.
struct RayErrors {
  dvec3 signs;         ///< of its displacement along each axis
  std::uint64_t word;  ///< gives each primitive signs for its distance and its texture coordinates
};

/// The tests of a scene's primitives as replicas perform them. Copies of a primitive have the same errors.
class RoundedTracing {
 public:
  /// `tracing` performs the exact tests, and its structure has room for displaced rays. `eye` is the camera's position,
  /// close to which the device stores a point of each sphere. References must outlive the object.
  RoundedTracing(const scene::Scene& scene, const Tracing& tracing, const dvec3& eye);

  /// Returns the closest hit. `ray` becomes the ray that, in effect, was tested.
  Hit closest(Ray& ray, Counters& counters, const RayErrors& errors) const;
  bool isOccluded(const Ray& ray, const RayEnd& end, Counters& counters, const RayErrors& errors) const;

 private:
  /// The rounding in the test of a shape has the effect of a displaced ray: by `units` of kRoundoff of the distance of
  /// the ray's origin from `centre`, plus `radius`.
  struct Reach {
    dvec3 centre;
    double radius;
    double units;
  };
  struct ReachOfShape;

  Reach reachOfShape(const Tracing::Item& item) const;
  std::uint32_t hashOfShape(const Tracing::Item& item) const;
  /// Returns the index of an item among the stored ones of `tracing`; nothing if it was made for an instance.
  std::optional<std::size_t> storedIndexOf(const Tracing::Item& item) const;
  /// Returns the origin of the ray that the device's test of this item amounts to.
  dvec3 testedOrigin(const Tracing::Item& item, const dvec3& origin, const dvec3& signs) const;
  /// Returns the sign of the error of the item's distance.
  double signOf(const Tracing::Item& item, std::uint64_t word) const;
  double roundedDistance(const Tracing::Item& item, double exact, std::uint64_t word) const;
  /// Returns what is added to the distance of an item in comparisons: those of needles are rounded up.
  double raisedBy(const Tracing::Item& item, const Ray& ray, std::uint64_t word) const;
  bool passes(const Tracing::Item& item, const Ray& ray, std::uint64_t word) const;

  const scene::Scene& scene_;
  const Tracing& tracing_;
  dvec3 eye_;
  std::vector<Reach> reaches_;         ///< of the stored items of `tracing`
  std::vector<std::uint32_t> hashes_;  ///< of their shapes
};

/// Returns the coordinates (s, t) of a texture at a point with these attributes, moved by the bounds of their errors in
/// the direction of `signs`; 0 without a texture.
dvec2 roundedTexCoords(const std::optional<scene::TextureReference>& texture, const MeshAttributes& attributes,
                       const dvec2& signs);

}  // namespace candela::reference
