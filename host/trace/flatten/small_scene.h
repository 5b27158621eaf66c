// Decides whether a scene is small: if it has few primitives, testing all of them sequentially from the uniform buffer
// is faster than traversing a structure (docs/performance-journal.md, "Constants read ahead, small scenes").
#pragma once
#include <cstdint>
#include <vector>

#include "host/scene/scene.h"

namespace candela::flatten {

/// The rule by which a device traces a scene without any structure: see device::smallSceneRule().
struct SmallSceneRule {
  std::uint32_t maxCost = 48;  ///< maximum cost of testing all primitives, in the units of TestCost (small_scene.cpp)
  bool rowsAhead = false;  ///< the kernel reads all records before anything else, which saves time if later reads are
                           ///< more expensive
};

/// Returns whether `rule` makes the scene a linear list: its cost is low enough, and it has at most
/// gpu::kMaxUniformSlots primitives, of which few are coincident (scene::Coincidences::coincident; empty: none), and
/// none of these emits.
bool isSmall(const scene::Scene& scene, const std::vector<bool>& coincident, const SmallSceneRule& rule);

}  // namespace candela::flatten
