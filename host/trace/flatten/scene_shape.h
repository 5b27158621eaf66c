// The shape of a flat scene: what kernels are specialised for, and what remains known of a scene after its records have
// been uploaded.
#pragma once
#include <array>
#include <cstdint>

#include "host/trace/render/choices_in_use.h"
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

struct SceneShape {
  SceneFeatures features;
  bool hasLens = false;                           ///< of the camera
  std::uint32_t structure = gpu::kStructureNone;  ///< kStructure...; a BVH of one leaf is kStructureNone
  std::uint32_t stackSize = 1;                    ///< entries that the traversal of a BVH needs
  std::uint32_t slotCount = 0;                    ///< primitives, planes included
  std::uint32_t uniformSlots = 0;     ///< primitives of a small scene, in FlatScene::slotRows too; 0: not small
  std::uint32_t firstMarkedSlot = 0;  ///< of these, the first that may coincide with another
  std::array<std::uint32_t, gpu::kUniformKindWords> uniformKinds{};  ///< kind and flags of each, a byte a slot
  std::uint32_t textureSlots = 0;                                    ///< a bit for each scene::TextureSlot in use
  std::uint32_t coincident = 0;                                      ///< kCoincident...
  float orderReach = 0;                                              ///< Coincidences::orderReach
  bool rowsAhead = false;                                            ///< SmallSceneRule::rowsAhead

  render::LayoutInUse layout() const;
};

}  // namespace candela::flatten
