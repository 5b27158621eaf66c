// Checks that the loops of a kernel fit into the limit of a device.
#include "host/device/loop_budget.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/core/errors.h"
#include "host/vulkan/loop_limit.h"

namespace candela::device {
namespace {

std::uint32_t lanesOf(const vulkan::DeviceInfo& info) { return std::max(1u, info.subgroupSize); }

constexpr std::uint32_t kOtherTurns = 64;  // light choice, permutations

// The segments of one lane in which it tests all primitives one by one, within half of the limit.
std::uint64_t bruteForceSegments(std::uint32_t limit, std::uint64_t primitives, std::uint32_t raysPerSegment) {
  return limit / 2 / (raysPerSegment * primitives + kOtherTurns);
}

std::uint32_t maxBruteForcePrimitives(std::uint32_t limit, std::uint32_t raysPerSegment) {
  return limit / 2 > kOtherTurns ? (limit / 2 - kOtherTurns) / raysPerSegment : 0;
}

}  // namespace

void preferTree(std::uint32_t limit, const vulkan::DeviceInfo& info, const scene::Scene& scene,
                std::uint32_t raysPerSegment, render::StructureSettings& structure,
                std::vector<std::string>& warnings) {
  const bool mayChange = structure.accel == render::AccelKind::none && structure.accelIsPreference;
  if (!mayChange || limit == vulkan::kUnlimitedTurns) return;
  if (bruteForceSegments(limit, scene.primitives.size(), raysPerSegment) > 0) return;
  structure.accel = render::AccelKind::bvh;
  warnings.push_back(
      fmt::format("the scene asks for no search structure, but {} can test at most {} of its {} primitives one by one: "
                  "a BVH is used, "
                  "which gives the same image",
                  info.name, maxBruteForcePrimitives(limit, raysPerSegment), scene.primitives.size()));
}

// So that a segment, of rays with at most four cells a slice, keeps to half of the limit even where no two lanes of
// a group look at cells at the same time. The other half is for what lies in the cells.
std::uint32_t maxGridSideFor(std::uint32_t limit, const vulkan::DeviceInfo& info, std::uint32_t raysPerSegment) {
  return limit == vulkan::kUnlimitedTurns ? flatten::kAnyGridSide
                                          : std::max(1u, limit / (8 * raysPerSegment * lanesOf(info)));
}

// Lanes that leave a loop at different turns add up within a group, lanes of a brute-force loop do not. Half of the
// device's limit is left for the turns that a lane does not count and for its last segment.
LoopBudget loopBudget(std::uint32_t limit, const vulkan::DeviceInfo& info, const flatten::FlatScene& flat,
                      std::uint32_t raysPerSegment) {
  if (limit == vulkan::kUnlimitedTurns) return {0xffffffffu, 0xffffffffu};
  if (flat.structure != gpu::kStructureNone) return {limit / 4, limit / (2 * lanesOf(info))};
  const std::uint64_t segments = bruteForceSegments(limit, flat.slotCount, raysPerSegment);
  if (segments > 0) return {static_cast<std::uint32_t>(segments), 0xffffffffu};
  throw FileError(
      fmt::format("--accel none over {} primitives: {} stops loops after {} iterations; at most {} primitives, or "
                  "use --accel bvh",
                  flat.slotCount, info.name, limit, maxBruteForcePrimitives(limit, raysPerSegment)));
}

}  // namespace candela::device
