// The scene as the device reads it: one array of 16-byte rows (shaders/shared/scene_rows.h), the constants that tell
// where its sections start, and which features it uses.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/flatten/small_scene.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"
#include "shaders/shared/features.h"
#include "shaders/shared/render_data.h"
#include "shaders/shared/specialization.h"

namespace candela::flatten {

/// Which parts of the kernel a scene needs, one flag for every entry of CANDELA_FEATURES; the others are compiled out.
struct SceneFeatures {
#define CANDELA_DECLARE_MEMBER(member, name, id) bool member = false;
  CANDELA_FEATURES(CANDELA_DECLARE_MEMBER)
#undef CANDELA_DECLARE_MEMBER
};

/// Of a structure's nodes, as --layout names them; empty where it has none of a BVH.
constexpr const char* layoutName(std::uint32_t structure) {
  if (structure == gpu::kStructureBvh) return "bvh2";
  return structure == gpu::kStructureWideBvh ? "cwbvh" : "";
}

inline constexpr std::uint32_t kAnyGridSide = 0xffffffffu;

struct FlatScene {
  std::vector<gpu::uvec4> rows;
  gpu::RenderConstants constants{};
  SceneFeatures features;
  std::uint32_t
      structure = gpu::kStructureNone;  ///< kStructure...; none for a BVH of one leaf: all primitives are tested
  std::uint32_t stackSize = 1;          ///< entries that the traversal of a BVH needs
  std::uint32_t
      uniformSlots = 0;  ///< all primitives of a small scene, whose rows are in `slotRows` too; 0: it is not small
  std::array<gpu::uvec4, gpu::kUniformRows> slotRows{};
  std::array<std::uint32_t, gpu::kUniformKindWords> uniformKinds{};  ///< kind and flags of each, a byte a slot
  bool rowsAhead = false;                                            ///< SmallSceneRule::rowsAhead
  std::uint32_t slotCount = 0;                                       ///< primitives, planes included
  double structureSeconds = 0;                                       ///< that building the search structure took
  std::map<std::string, double> structureQuality;
};

/// What of a flat scene depends on the device.
struct FlattenLimits {
  std::uint32_t maxGridSide = kAnyGridSide;  ///< cells along an axis of a grid
  SmallSceneRule smallScene;
};

/// Derives every row in double precision from the scene's binary32 values, rounding once. The scene has a camera.
/// Throws FileError if it exceeds a limit of the layout.
FlatScene flattenScene(const scene::Scene& scene, const render::RenderSettings& settings,
                       const FlattenLimits& limits = {});

}  // namespace candela::flatten
