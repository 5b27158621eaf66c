// How many loop turns a device grants one shader invocation before it stops the loop without a word.
#pragma once
#include <cstdint>

namespace candela::vulkan {

class Device;

inline constexpr std::uint32_t kUnlimitedTurns = 0xffffffffu;

/// Runs a loop of 2^20 turns in one invocation: kUnlimitedTurns if all of them ran, else how many did. lavapipe stops
/// at about 65,535 turns of all loops of an invocation together, and counts a turn if any lane of its group of 4 to 16
/// is active, so a lane's own budget is this number divided by the subgroup's size if lanes diverge.
std::uint32_t probeLoopLimit(Device& device);

}  // namespace candela::vulkan
