// Checks that the loops of a kernel fit into the limit of a device.
#include "host/trace/device/loop_budget.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/trace/flatten/flat_scene.h"
#include "host/trace/vulkan/loop_limit.h"

namespace candela::device {
namespace {

std::uint32_t subgroupSizeOf(const vulkan::DeviceInfo& info) { return std::max(1u, info.subgroupSize); }

constexpr std::uint32_t kOtherIterations = 64;  // light choice, permutations

// Segments in which one invocation can test all primitives sequentially within half of the limit.
std::uint64_t bruteForceSegments(std::uint32_t limit, std::uint64_t primitives, std::uint32_t raysPerSegment) {
  return limit / 2 / (raysPerSegment * primitives + kOtherIterations);
}

// Brute force over more primitives makes a segment of a few pixels so long that drivers may end it.
constexpr std::size_t kMaxPreferredBruteForce = std::size_t{1} << 18;

std::uint32_t maxBruteForcePrimitives(std::uint32_t limit, std::uint32_t raysPerSegment) {
  return limit / 2 > kOtherIterations ? (limit / 2 - kOtherIterations) / raysPerSegment : 0;
}

}  // namespace

void preferBvh(std::uint32_t limit, const vulkan::DeviceInfo& info, const scene::Scene& scene,
               std::uint32_t raysPerSegment, render::StructureSettings& structure, std::vector<std::string>& warnings) {
  const bool mayChange = structure.accel == render::AccelKind::none && structure.accelIsPreference;
  if (!mayChange) return;
  if (scene.primitives.size() > kMaxPreferredBruteForce) {
    structure.accel = render::AccelKind::bvh;
    warnings.push_back(fmt::format(
        "the scene requests no acceleration structure for {} primitives: a BVH is used, which gives the same image and "
        "keeps work on {} short; {} traces without one",
        scene.primitives.size(), info.name, settingWords("accel", "none")));
    return;
  }
  if (limit == vulkan::kUnlimitedIterations) return;
  if (bruteForceSegments(limit, scene.primitives.size(), raysPerSegment) > 0) return;
  structure.accel = render::AccelKind::bvh;
  warnings.push_back(
      fmt::format("the scene requests no acceleration structure, but {} can test at most {} of its {} primitives "
                  "sequentially: a BVH is used, which gives the same image",
                  info.name, maxBruteForcePrimitives(limit, raysPerSegment), scene.primitives.size()));
}

// The side is chosen so that a segment, of rays with at most four cells per slice, stays within half of the limit even
// if no two invocations of a subgroup visit cells in the same iteration. The other half is for the items of the cells.
std::uint32_t maxGridSideFor(std::uint32_t limit, const vulkan::DeviceInfo& info, std::uint32_t raysPerSegment) {
  return limit == vulkan::kUnlimitedIterations ? flatten::kAnyGridSide
                                               : std::max(1u, limit / (8 * raysPerSegment * subgroupSizeOf(info)));
}

// In lavapipe's groups of invocations, iterations add up if the invocations exit a loop at different iterations; those
// of a brute-force loop do not. Half of the device's limit is left for iterations that an invocation does not count and
// for its last segment.
LoopBudget loopBudget(std::uint32_t limit, const vulkan::DeviceInfo& info, const flatten::SceneShape& shape,
                      std::uint32_t raysPerSegment) {
  if (limit == vulkan::kUnlimitedIterations) return {0xffffffffu, 0xffffffffu};
  const bool hasNodes = shape.structure != gpu::kStructureNone || shape.features.instances;
  if (hasNodes) return {limit / 4, limit / (2 * subgroupSizeOf(info))};
  const std::uint64_t segments = bruteForceSegments(limit, shape.slotCount, raysPerSegment);
  if (segments > 0) return {static_cast<std::uint32_t>(segments), 0xffffffffu};
  throw FileError(fmt::format(
      "no acceleration structure for {} primitives: {} stops loops after {} iterations, which allows at most {} "
      "primitives; use {}",
      shape.slotCount, info.name, limit, maxBruteForcePrimitives(limit, raysPerSegment), settingWords("accel", "bvh")));
}

}  // namespace candela::device
