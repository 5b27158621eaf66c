// Intersections of rays with a scene: by a linear list of all primitives, or through a BVH or a grid.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "host/reference/geometry.h"
#include "host/reference/grid.h"
#include "host/reference/hierarchy.h"
#include "host/reference/light_margin.h"
#include "host/reference/ray.h"
#include "host/reference/rounding.h"
#include "host/reference/rounding_reach.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::reference {

/// Counts of one thread's work.
struct Counters {
  std::uint64_t samples = 0;
  std::uint64_t cameraRays = 0;
  std::uint64_t bounceRays = 0;
  std::uint64_t cameraHits = 0;  ///< this and the next two: Whitted only
  std::uint64_t reflectedRays = 0;
  std::uint64_t refractedRays = 0;
  std::uint64_t shadowRays = 0;
  std::uint64_t vertices = 0;
  std::uint64_t volumeFaults = 0;    ///< rays whose volumes are not nested or not closed
  std::uint64_t traversalSteps = 0;  ///< nodes or cells visited plus primitives tested

  Counters& operator+=(const Counters& other);
};

class Tracing {
 public:
  /// The default BVH is not built for this number of primitives or fewer. Other structures are built for any number.
  static constexpr std::size_t kBruteForceLimit = 32;

  /// Uses `accel` of `settings` with its options, and `oneSided`. The scene must outlive the object.
  Tracing(const scene::Scene& scene, const render::RenderSettings& settings);

  /// Moves the eye, on which the margin of spheres depends (docs/light-transport.md section 6). The rounding of
  /// replicas depends on it, too: if they are traced, the structure is built again.
  void setEye(const dvec3& eye);

  /// Returns the closest hit; of equal distances that of the lower primitive index.
  Hit closest(const Ray& ray, Counters& counters) const;
  /// Returns whether a primitive hides the light at `end`.
  bool isOccluded(const Ray& ray, const RayEnd& end, Counters& counters) const;

  /// These overloads apply the rounding of a replica: `ray` becomes the ray that, in effect, was tested.
  Hit closest(Ray& ray, Counters& counters, Rounding& rounding) const;
  bool isOccluded(const Ray& ray, const RayEnd& end, Counters& counters, Rounding& rounding) const;

  bool hasHierarchy() const { return !hierarchy_.nodes.empty(); }
  const Hierarchy& hierarchy() const { return hierarchy_; }
  bool hasGrid() const { return !grid_.starts.empty(); }
  const Grid& grid() const { return grid_; }

 private:
  Tracing(const scene::Scene& scene, const render::RenderSettings& settings, const dvec3& eye);

  /// A primitive to test.
  struct Item {
    Shape shape;
    bool oneSided;
    bool transparent;
    bool emits;
    bool transmits;
    bool thinWalled;  ///< transmits without bounding a volume
    bool behind;      ///< an emitter that coincides with it is in front of it
    std::uint32_t material;
    std::uint32_t primitive;
    std::uint32_t firstCopy;  ///< the lowest index of a primitive of the same shape; perturbed by the same errors
  };

  void addItem(const scene::Scene& scene, std::uint32_t index, bool oneSided, bool behind);
  double distance(const Item& item, const Ray& ray) const;
  /// Returns the distance that an item which is hit at distance `t` counts for, in comparisons with others.
  double comparedDistance(const Item& item, const Ray& ray, double t) const;
  /// Returns whether the item, which `ray` hits at distance `t` before its `end`, contains the light there. `fraction`
  /// is kLightMargin, perturbed by the rounding of a replica.
  bool containsLight(const Item& item, const Ray& ray, double t, const RayEnd& end, double fraction) const;
  /// Returns whether a ray passes an item that it would otherwise hit. `word`: of the rounding of a replica; 0:
  /// exactly.
  bool passes(const Item& item, const Ray& ray, std::uint64_t word) const;
  /// Returns whether an item that `ray` hits at distance `t` hides an emitter that coincides with it: of both, a ray
  /// sees the closer one, or the one with the lower index. `lightDistance` is the distance of the emitter. Returns
  /// nothing if the item does not emit, or they do not coincide.
  std::optional<bool> hidesEmitter(const Item& item, double t, const Item& light, double lightDistance) const;
  void prepareReplicas();
  /// The origin of the ray that the device's test of this item amounts to; `signs` of the errors.
  dvec3 testedOrigin(const Item& item, const dvec3& origin, const dvec3& signs) const;
  /// `exact` with the error of this item; `word` is the ray's.
  double roundedDistance(const Item& item, double exact, std::uint64_t word) const;
  template <class Visit>
  void visitItems(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const;
  template <class Visit>
  bool visitHierarchy(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const;
  template <class Visit>
  bool visitGrid(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const;

  const scene::Scene* scene_;
  render::RenderSettings settings_;
  dvec3 eye_;
  std::vector<Item> items_;             ///< in the structure's order, then those outside of the structure
  std::vector<std::uint32_t> itemOf_;   ///< index in items_ of each primitive; undefined for those that are never hit
  std::size_t firstOutside_ = 0;        ///< index of the first item outside of the structure
  double behindReach_ = 0;              ///< largest coordinate of the items that are behind emitters, and of these
  std::vector<RoundingReach> reaches_;  ///< of items_; empty unless replicas are traced
  Hierarchy hierarchy_;
  Grid grid_;
};

}  // namespace candela::reference
