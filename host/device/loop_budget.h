// How many loop turns a dispatch may take on devices that stop loops after a number of them (host/vulkan/loop_limit.h).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "host/flatten/flat_scene.h"
#include "host/vulkan/device_info.h"

namespace candela::device {

/// What the device may do in one dispatch without running into its loop limit.
struct LoopBudget {
  std::uint32_t maxSegments = 0;  ///< segments of one lane
  std::uint32_t laneTurns = 0;    ///< loop turns after which a lane begins no further segment
};

/// `limit` is what probeLoopLimit() found, `raysPerSegment` the most that one segment traces. Throws FileError where
/// brute force over the scene exceeds it.
LoopBudget loopBudget(std::uint32_t limit, const vulkan::DeviceInfo& info, const flatten::FlatScene& flat,
                      std::uint32_t raysPerSegment);

/// Where `structure` prefers AccelKind::none and the limit does not let the device test all primitives of the scene one
/// by one, chooses a BVH instead and adds a sentence to `warnings`.
void preferTree(std::uint32_t limit, const vulkan::DeviceInfo& info, const scene::Scene& scene,
                std::uint32_t raysPerSegment, render::StructureSettings& structure, std::vector<std::string>& warnings);

/// The finest grid, in cells along an axis, whose empty cells alone do not use up the limit.
std::uint32_t maxGridSideFor(std::uint32_t limit, const vulkan::DeviceInfo& info, std::uint32_t raysPerSegment);

}  // namespace candela::device
