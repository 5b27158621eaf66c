// Checks the workgroup size against the limits of a device.
#include "host/trace/device/workgroup.h"

#include <fmt/format.h>

#include "host/base/errors.h"

namespace candela::device {

bool hasWorkgroup(const vulkan::DeviceInfo& info, const render::Extent& workgroup) {
  const std::uint64_t lanes = std::uint64_t{workgroup.width} * workgroup.height;
  return lanes > 0 && lanes <= info.maxWorkgroupInvocations && workgroup.width <= info.maxWorkgroupSize[0] &&
         workgroup.height <= info.maxWorkgroupSize[1];
}

void requireWorkgroup(const vulkan::DeviceInfo& info, const render::Extent& workgroup) {
  if (hasWorkgroup(info, workgroup)) return;
  throw UsageError(fmt::format(
      "a workgroup of {}x{} invocations: {} supports at most {} invocations per workgroup, {} by {}", workgroup.width,
      workgroup.height, info.name, info.maxWorkgroupInvocations, info.maxWorkgroupSize[0], info.maxWorkgroupSize[1]));
}

}  // namespace candela::device
