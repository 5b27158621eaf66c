// Whether a device has workgroups of some size.
#pragma once
#include "host/render/extent.h"
#include "host/vulkan/device_info.h"

namespace candela::device {

bool hasWorkgroup(const vulkan::DeviceInfo& info, const render::Extent& workgroup);
/// Throws UsageError, which names the device's limits, if it has not.
void requireWorkgroup(const vulkan::DeviceInfo& info, const render::Extent& workgroup);

}  // namespace candela::device
