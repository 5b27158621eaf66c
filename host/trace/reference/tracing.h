// Intersections of rays with a scene: by a linear list of all primitives, or through a BVH or a grid.
#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/scene/scene.h"
#include "host/scene/stored_primitives.h"
#include "host/trace/reference/geometry.h"
#include "host/trace/reference/grid.h"
#include "host/trace/reference/hierarchy.h"
#include "host/trace/reference/instances.h"
#include "host/trace/reference/light_margin.h"
#include "host/trace/reference/ray.h"
#include "host/trace/render/settings.h"

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

/// The primitives of a scene, and the structure through which rays find them.
class Tracing {
 public:
  /// The default BVH is not built for this number of primitives or fewer. Other structures are built for any number.
  static constexpr std::size_t kBruteForceLimit = 32;

  /// A primitive to test.
  struct Item {
    Shape shape;
    bool oneSided;
    bool transparent;
    bool emits;
    bool transmits;
    bool thinWalled;  ///< transmits without bounding a volume
    bool ordered;     ///< its place in the order in a plane matters
    std::uint32_t material;
    std::uint32_t primitive;
  };

  /// A hit as it is compared with others. Of equal distances, ordered ones come last, then the higher indices.
  struct Candidate {
    double distance = kNoHit;
    bool ordered = true;
    std::uint32_t primitive = kNoPrimitive;

    auto operator<=>(const Candidate&) const = default;
  };

  /// Uses `accel` of `settings` with its options, and `oneSided`. The scene must outlive the object.
  Tracing(const scene::Scene& scene, const render::RenderSettings& settings);

  /// Moves the eye, on which the margin of spheres depends (docs/light-transport.md section 6). The boxes for replicas
  /// depend on it, too: if they are traced, the structure is built again.
  void setEye(const dvec3& eye);

  /// Returns the closest hit; of equal distances that of the lower primitive index.
  Hit closest(const Ray& ray, Counters& counters) const;
  /// Returns whether a primitive hides the light at `end`.
  bool isOccluded(const Ray& ray, const RayEnd& end, Counters& counters) const;

  bool hasHierarchy() const { return !hierarchy_.nodes.empty() || !instances_.empty(); }
  /// Returns the number of nodes of all BVHs.
  std::size_t nodeCount() const { return hierarchy_.nodes.size() + instances_.nodeCount(); }
  const Instances& instances() const { return instances_; }
  bool hasGrid() const { return !grid_.starts.empty(); }
  const Grid& grid() const { return grid_; }

  /// The items that are stored: those of primitives that are in no instance.
  const std::vector<Item>& items() const { return items_; }
  /// Returns the item of a primitive; null for kNoPrimitive. Undefined for primitives that are never hit. In a scene
  /// with instances, the item is made in `made`, which must outlive the result.
  const Item* itemOf(std::uint32_t primitive, std::optional<Item>& made) const {
    if (primitive == kNoPrimitive) return nullptr;
    return itemOf_.empty() ? makeItem(primitive, made) : &items_[itemOf_[primitive]];
  }
  /// Calls visit(item) for the items that a ray may hit before `limit`, which `visit` may reduce. Ends when `visit`
  /// returns true. Defined in visit_items.h.
  template <class Visit>
  void visitItems(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const;
  /// Returns the distance at which a ray hits an item by the rules for `origin`, the item of its origin primitive.
  double distance(const Item& item, const Ray& ray, const Item* origin) const;
  /// `t` is the distance at which `ray` hits the item.
  Candidate candidate(const Item& item, const Ray& ray, double t) const {
    return {comparedDistance(item, ray, t), item.ordered, item.primitive};
  }
  /// Returns whether the item, which `ray` hits at distance `t` before its `end`, contains the light there. `fraction`
  /// is kLightMargin, or the same perturbed by rounding.
  bool containsLight(const Item& item, const Ray& ray, double t, const RayEnd& end, double fraction) const;
  /// Returns whether an item that a ray hits at distance `t` hides an emitter that coincides with it: of both, a ray
  /// sees the closer one, or the one with the lower index. `lightDistance` is the distance of the emitter. Returns
  /// nothing if the item does not emit, or they do not coincide.
  std::optional<bool> hidesEmitter(const Item& item, double t, const Item& light, double lightDistance) const;
  /// Returns whether an item may coincide with another one. It is known only if the settings have replicas.
  bool mayCoincide(const Item& item) const {
    return !coincident_.empty() && coincident_[stored_->indexOf(item.primitive)];
  }

 private:
  Tracing(const scene::Scene& scene, const render::RenderSettings& settings, const dvec3& eye);

  Item madeItem(const scene::Primitive& primitive, std::uint32_t index) const;
  const Item* makeItem(std::uint32_t primitive, std::optional<Item>& made) const;
  /// Returns the distance that an item which is hit at distance `t` counts for, in comparisons with others.
  double comparedDistance(const Item& item, const Ray& ray, double t) const;
  /// Returns whether a ray passes an item that it would otherwise hit.
  bool passes(const Item& item, const Ray& ray) const;
  template <class Visit>
  bool visitGrid(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const;

  const scene::Scene* scene_;
  render::RenderSettings settings_;
  dvec3 eye_;
  /// The items of primitives that are in none of instances_, in the structure's order, then those outside of the
  /// structure. Those of instances are made when they are tested.
  std::vector<Item> items_;
  std::vector<std::uint32_t> itemOf_;  ///< index in items_ of each primitive that may be hit; empty with instances
  std::size_t firstOutside_ = 0;       ///< index of the first item outside of the structure
  double orderReach_ = 0;         ///< largest coordinate of the items that are ordered, and of those in their planes
  std::vector<bool> ordered_;     ///< by number in stored_; empty if no primitive is ordered
  std::vector<bool> coincident_;  ///< as well, for replicas
  std::optional<scene::StoredPrimitives> stored_;  ///< nothing if neither is needed
  Hierarchy hierarchy_;                            ///< over items_
  Instances instances_;
  Grid grid_;
};

}  // namespace candela::reference
