// The number of loop iterations that a dispatch may execute on devices with a loop limit
// (host/trace/vulkan/loop_limit.h).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/flatten/scene_shape.h"
#include "host/trace/render/settings.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::device {

/// The work of one dispatch that stays below the device's loop limit.
struct LoopBudget {
  std::uint32_t maxSegments = 0;    ///< segments of one invocation
  std::uint32_t maxIterations = 0;  ///< loop iterations after which an invocation starts no further segment
};

/// `limit` is the result of probeLoopLimit(), `raysPerSegment` the maximum number of rays that a segment traces. Throws
/// FileError if brute force over the scene exceeds the limit.
LoopBudget loopBudget(std::uint32_t limit, const vulkan::DeviceInfo& info, const flatten::SceneShape& shape,
                      std::uint32_t raysPerSegment);

/// If `structure` prefers AccelKind::none and the scene has more than 2^18 primitives, or the limit does not let the
/// device test all of them sequentially, chooses a BVH instead and adds a sentence to `warnings`.
void preferBvh(std::uint32_t limit, const vulkan::DeviceInfo& info, const scene::Scene& scene,
               std::uint32_t raysPerSegment, render::StructureSettings& structure, std::vector<std::string>& warnings);

/// Maximum number of cells along an axis of a grid whose empty cells alone do not exceed the limit.
std::uint32_t maxGridSideFor(std::uint32_t limit, const vulkan::DeviceInfo& info, std::uint32_t raysPerSegment);

}  // namespace candela::device
