// The scene in the format that the device reads: one array of 16-byte records (shaders/shared/scene_rows.h), the
// constants with the first indices of its sections, and the features that it uses.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/flatten/small_scene.h"
#include "host/render/choices_in_use.h"
#include "host/scene/scene.h"
#include "lists/features.h"
#include "shaders/shared/render_data.h"
#include "shaders/shared/specialization.h"

namespace candela::flatten {

/// The parts of the kernel that a scene needs, one flag for every entry of CANDELA_FEATURES. The others are compiled
/// out.
struct SceneFeatures {
#define CANDELA_DECLARE_MEMBER(member, name, id) bool member = false;
  CANDELA_FEATURES(CANDELA_DECLARE_MEMBER)
#undef CANDELA_DECLARE_MEMBER
};

/// Returns all features of a scene except those that noteLights() sets.
SceneFeatures featuresOf(const scene::Scene& scene, render::Integrator integrator);

inline constexpr std::uint32_t kAnyGridSide = 0xffffffffu;

struct FlatScene {
  std::vector<gpu::uvec4> rows;
  gpu::RenderConstants constants{};
  SceneFeatures features;
  std::uint32_t structure = gpu::kStructureNone;  ///< kStructure...; a BVH of one leaf is kStructureNone
  std::uint32_t stackSize = 1;                    ///< entries that the traversal of a BVH needs
  std::uint32_t uniformSlots = 0;                 ///< primitives of a small scene, in `slotRows` too; 0: not small
  std::uint32_t firstMarkedSlot = 0;              ///< of these, the first that may coincide with another
  std::array<gpu::uvec4, gpu::kUniformRows> slotRows{};
  std::array<std::uint32_t, gpu::kUniformKindWords> uniformKinds{};  ///< kind and flags of each, a byte a slot
  std::uint32_t textureSlots = 0;                                    ///< a bit for each scene::TextureSlot in use
  std::uint32_t coincident = 0;                                      ///< kCoincident...
  float behindReach = 0;                                             ///< Coincidences::behindReach
  bool rowsAhead = false;                                            ///< SmallSceneRule::rowsAhead
  std::uint32_t slotCount = 0;                                       ///< primitives, planes included
  double structureSeconds = 0;                                       ///< time of building the acceleration structure
  std::map<std::string, double> structureQuality;

  render::LayoutInUse layout() const;
};

/// Limits of a flat scene that depend on the device.
struct FlattenLimits {
  std::uint32_t maxGridSide = kAnyGridSide;  ///< cells along an axis of a grid
  SmallSceneRule smallScene;
};

/// Computes every record in double precision from the scene's binary32 values, rounding once. The scene must have a
/// camera. Throws FileError if it exceeds a limit of the layout.
FlatScene flattenScene(const scene::Scene& scene, const render::RenderSettings& settings,
                       const FlattenLimits& limits = {});

}  // namespace candela::flatten
