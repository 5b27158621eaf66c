// Scenes of so few primitives that testing all of them, in a row and from the uniform buffer, is faster than traversing
// a structure (docs/performance.md).
#pragma once
#include <cstdint>

#include "host/scene/scene.h"
#include "host/vulkan/device_info.h"

namespace candela::flatten {

/// Which scenes a device traces without any structure.
struct SmallSceneRule {
  std::uint32_t maxCost = 48;  ///< of testing all primitives, in the units of rowCost()
  bool rowsAhead = false;  ///< the kernel reads all rows before anything else: worth it where a read costs more later
};

/// As measured on lavapipe; on other devices, sixteen triangles.
SmallSceneRule smallSceneRule(const vulkan::DeviceInfo& info);

/// Whether `rule` has the scene traced in a row: it costs little enough, and has at most gpu::kMaxUniformSlots
/// primitives.
bool isSmall(const scene::Scene& scene, const SmallSceneRule& rule);

}  // namespace candela::flatten
