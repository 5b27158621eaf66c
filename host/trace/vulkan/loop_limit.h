// The number of loop iterations after which a device silently stops the loop of an invocation.
#pragma once
#include <cstdint>

namespace candela::vulkan {

class Device;

inline constexpr std::uint32_t kUnlimitedIterations = 0xffffffffu;

/// Runs a loop of 2^17 iterations in one invocation. Returns kUnlimitedIterations if all of them ran, else their
/// number. lavapipe stops after about 65,535 iterations of all loops of an invocation in total. It counts an iteration
/// if any lane of its SIMD group of 4 to 16 invocations is active, so that the budget of one invocation is this number
/// divided by the subgroup size if invocations diverge.
std::uint32_t probeLoopLimit(Device& device);

}  // namespace candela::vulkan
