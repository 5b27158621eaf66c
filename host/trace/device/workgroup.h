// Checks whether a device supports a workgroup size.
#pragma once
#include "host/trace/render/extent.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::device {

bool hasWorkgroup(const vulkan::DeviceInfo& info, const render::Extent& workgroup);
/// Throws UsageError, which names the device's limits, if it does not.
void requireWorkgroup(const vulkan::DeviceInfo& info, const render::Extent& workgroup);

}  // namespace candela::device
