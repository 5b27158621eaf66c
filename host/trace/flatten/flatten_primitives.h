// Stores primitives as 16-byte records.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/flatten/flat_rows.h"
#include "host/trace/flatten/flat_scene.h"
#include "host/trace/flatten/light_table.h"

namespace candela::flatten {

/// Data about a primitive that its entry in the scene does not contain.
struct PrimitiveContext {
  scene::Primitive primitive;     ///< without its placement, if its instance is stored as such
  std::uint32_t index = 0;        ///< in Scene::primitives; for an instance from its first primitive
  std::uint32_t reference = 0;    ///< of a sphere: its index in the light table + 1, or 0; of a triangle: its geometry
  bool touched = false;           ///< the surface may contain a light: touched_primitives.h
  std::uint32_t coincidence = 0;  ///< flags of a surface with which another one may coincide
  bool ordered = false;           ///< its place in the order in a plane matters
};

/// Marks of primitives that depend on others, by number in scene::StoredPrimitives.
struct PrimitiveMarks {
  std::vector<bool> touched;     ///< result of touchedPrimitives()
  std::vector<bool> coincident;  ///< Coincidences::coincident
  std::vector<bool> ordered;     ///< Coincidences::ordered
};

/// Returns kFlagCoincident and the flags that tell how rays cross a primitive that coincides with others.
std::uint32_t coincidenceFlags(const scene::Scene& scene, const scene::Primitive& primitive,
                               render::Integrator integrator);

/// Returns the kCoincident... of a scene with these marks, by number in scene::StoredPrimitives.
std::uint32_t coincidentKinds(const scene::Scene& scene, const std::vector<bool>& coincident,
                              render::Integrator integrator);

/// Sets the parts of a sphere's first two records that depend on the eye: the anchor, and the unit vector from the
/// centre to the anchor.
void placeSphere(const scene::Sphere& sphere, const glm::vec3& eye, std::span<gpu::uvec4, 2> rows);

/// The primitives in the order of their slots.
struct SlotOrder {
  std::vector<std::uint32_t> own;                        ///< those that belong to no instance, and copies
  std::vector<std::vector<std::uint32_t>> ofPrototypes;  ///< InstanceSlots::orders
  std::vector<bool> isInstance;                          ///< InstancePlan::isInstance
};

/// Appends the records of the primitives, followed by their geometries, and sets the constants that refer to them.
/// `table` is the light table.
void appendPrimitives(const scene::Scene& scene, const SlotOrder& order, std::span<const LightEntry> table,
                      const PrimitiveMarks& marks, const render::ImageSettings& image, FlatScene& flat);

/// Copies the records of slots to the uniform buffer.
void copySlotRows(FlatScene& flat);

}  // namespace candela::flatten
