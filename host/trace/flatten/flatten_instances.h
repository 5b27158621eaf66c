// Stores instances: their meshes once, an 8-wide BVH for each, and one over all instances.
#pragma once
#include <cstdint>
#include <vector>

#include "host/scene/coincidence/coincidence.h"
#include "host/scene/scene.h"
#include "host/trace/accel/bounds.h"
#include "host/trace/flatten/flat_scene.h"

namespace candela::flatten {

/// Triangles of a mesh with one material, as instances show them.
struct Prototype {
  std::vector<std::uint32_t> uses;  ///< the runs of Scene::primitives that show it; never empty
  std::uint32_t triangleCount = 0;
  accel::Aabb bounds;       ///< of the vertices, in the space of the mesh
  bool coincident = false;  ///< some triangle may coincide with another surface
};

/// The instances of a scene that are stored as such. The primitives of the others are copied, which changes no bit.
struct InstancePlan {
  std::vector<Prototype> prototypes;
  std::vector<bool> isInstance;     ///< by run of Scene::primitives; empty: there are no instances
  std::uint32_t triangleCount = 0;  ///< of all prototypes
  float coincidentReach = 0;        ///< largest coordinate of instances with triangles that may coincide with others

  bool hasInstances() const { return !prototypes.empty(); }
};

/// Besides the runs that scene::isInstance() excludes, those whose triangles no other run shows with their material are
/// copied. Grids, binary BVHs and lists have no instances.
InstancePlan planInstances(const scene::Scene& scene, const scene::Coincidences& coincidences,
                           const render::RenderSettings& settings);

/// An instance: a run of Scene::primitives that shows a prototype, by its index.
struct InstanceUse {
  std::uint32_t run;
  std::uint32_t prototype;
};

/// The slots of instances' triangles: primitive indices of the first use of each prototype.
struct InstanceSlots {
  std::vector<std::vector<std::uint32_t>> orders;  ///< by prototype, in the order of the leaves of its BVH
  std::vector<InstanceUse> uses;                   ///< in the order of the leaves of the BVH over instances
  std::vector<std::uint32_t> roots;                ///< by prototype: the node of the root of its BVH
};

/// Builds the BVHs, and appends their nodes behind those of the scene's own BVH, which must be the last records.
/// `slotCount`: the number of slots before those of instances.
InstanceSlots appendInstanceHierarchies(const scene::Scene& scene, const InstancePlan& plan,
                                        const render::RenderSettings& settings, std::uint32_t slotCount,
                                        FlatScene& flat);

/// Appends the records of instances, and sets the constant that refers to them. `coincidentReach` is that of
/// accel::SceneBounds.
void appendInstances(const scene::Scene& scene, const InstancePlan& plan, const InstanceSlots& slots,
                     float coincidentReach, FlatScene& flat);

}  // namespace candela::flatten
