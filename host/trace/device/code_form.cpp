// Tells devices apart by what they are.
#include "host/trace/device/code_form.h"

#include "host/trace/vulkan/device.h"
#include "host/trace/vulkan/loop_limit.h"

namespace candela::device {

CodeForm codeFormOf(const vulkan::DeviceInfo& info, std::uint32_t loopLimit) {
  const bool isSoftware = info.isSoftware();
  return {.masksLanes = isSoftware, .limitsLoops = isSoftware || loopLimit != vulkan::kUnlimitedIterations};
}

render::SceneLoads fasterLoads(const vulkan::LoadTimes& times) {
  constexpr double kTolerated = 1.25;
  return times.storage <= kTolerated * times.texel ? render::SceneLoads::storage : render::SceneLoads::texel;
}

render::SceneLoads fastestLoads(vulkan::Device& device) {
  return device.info().isSoftware() ? fasterLoads(vulkan::probeLoads(device)) : render::SceneLoads::texel;
}

flatten::SmallSceneRule smallSceneRule(const vulkan::DeviceInfo& info) {
  if (!info.isSoftware()) return {};
  constexpr std::uint32_t kWide = 8;  // the vectors of AVX2
  if (info.subgroupSize >= kWide) return {.maxCost = 128, .rowsAhead = true};
  return {.maxCost = 0};
}

}  // namespace candela::device
