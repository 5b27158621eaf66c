// Sections of the scene buffer, each of which has a separate file. shaders/shared/scene_rows.h has their layouts.
#pragma once
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "host/trace/accel/primitive_bounds.h"
#include "host/trace/accel/wide_bvh.h"
#include "host/trace/flatten/flat_rows.h"
#include "host/trace/flatten/flat_scene.h"
#include "host/trace/flatten/light_table.h"

namespace candela::flatten {

/// Appends the records of the light table, followed by the cones of its spot lights, and sets the constants that refer
/// to them. `order`: the primitives in the order of their slots.
void appendLights(const scene::Scene& scene, const LightTable& table, std::span<const std::uint32_t> order,
                  FlatScene& flat);

/// Appends the records of instances that emit and of the trees of their meshes. Returns the first record of each
/// instance, by its entry in the table.
std::unordered_map<std::uint32_t, std::uint32_t> appendLightInstances(const scene::Scene& scene,
                                                                      const LightTable& table,
                                                                      std::span<const std::uint32_t> order,
                                                                      FlatScene& flat);

/// Appends the records of the nodes of a tree.
void appendLightNodes(const LightTree& tree, Rows& rows);

/// Appends the records of a light tree, which is chosen by the numbers below a threshold in units of 2^-24.
void appendLightTree(const LightTree& tree, std::uint32_t threshold, FlatScene& flat);

/// Sets the features that follow from the light table, which is empty for the Whitted tracer, and from the primitives
/// that lights touch: see touchedPrimitives().
void noteLights(std::span<const LightEntry> table, const std::vector<bool>& touched, SceneFeatures& features);

/// Builds the grid over the finite primitives, appends its cells and items to `flat`, and returns the indices of these
/// primitives in the order in which cells first refer to them. Without finite primitives there is no grid.
std::vector<std::uint32_t> appendGrid(const accel::SceneBounds& bounds, float density, std::uint32_t maxSide,
                                      FlatScene& flat);

/// Appends all nodes of a compressed 8-wide BVH, gaps included.
void appendWideNodes(const accel::WideBvh& wide, Rows& rows);

/// Returns the records of the Whitted tracer's lights: all point lights in the given order, as squares of side `size`
/// (0: points) that face the camera's target: see docs/light-transport.md section 9.
Rows pointLightRows(std::span<const scene::PointLight> lights, const scene::Camera& camera, double size);
/// Appends these records, and sets the constants that refer to them.
void appendPointLights(const scene::Scene& scene, double lightSize, FlatScene& flat);

/// The surfaces of a scene's materials in the order of their records.
struct SurfaceOrder {
  std::vector<std::uint32_t> materials;  ///< of each surface; those that bound volumes come first
  std::vector<std::uint32_t> numbers;    ///< by material: index of its surface + 1, or 0
  std::uint32_t volumeCount = 0;
};

/// Throws FileError if there are more volumes than a path's record can name.
SurfaceOrder orderSurfaces(const scene::Scene& scene);
Rows surfaceRows(const scene::Scene& scene, const SurfaceOrder& order);
/// Returns the records of the energy tables, of the glass tables if there are volumes, of the sheen table if there is a
/// sheen, and of the tables for anisotropic microfacets if there are any.
Rows energyRows(const SceneFeatures& features);

/// Appends the records of materials: lobes and emission as the integrator sees them.
void appendMaterials(const scene::Scene& scene, render::Integrator integrator, const SurfaceOrder& order,
                     FlatScene& flat);
/// Appends the records of surfaces and of the energy tables that they need.
void appendSurfaces(const scene::Scene& scene, const SurfaceOrder& order, FlatScene& flat);

/// Returns the linear values of 8-bit sRGB: kSrgbTableRows records.
Rows srgbTableRows();

/// Returns a bit for each scene::TextureSlot that some material uses.
std::uint32_t textureSlotsOf(const scene::Scene& scene);

/// Returns whether some image has channels of 16 bits.
bool hasDeepTexels(const scene::Scene& scene);

/// Returns the table of linear values of sRGB, the references of materials to images, and the images. Throws FileError
/// beyond kMaxTextureRows records.
Rows textureRows(const scene::Scene& scene);

/// Returns the headers of the sky box's faces, the table of linear values of 8-bit sRGB, and the texels.
Rows skyRows(const scene::Sky& sky);

/// Appends the texels of the environment with their densities, and the intervals of random numbers that choose a row
/// and a texel of it, and sets its constants.
void appendEnvironment(const scene::Environment& environment, FlatScene& flat);

}  // namespace candela::flatten
