// Whether a device has workgroups of some size.
#pragma once
#include "host/render/extent.h"
#include "host/vulkan/device_info.h"

namespace candela {

bool hasWorkgroup(const DeviceInfo& info, const Extent& workgroup);
/// Throws UsageError, which names the device's limits, if it has not.
void requireWorkgroup(const DeviceInfo& info, const Extent& workgroup);

}  // namespace candela
