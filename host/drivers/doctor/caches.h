// Examines the folder of compiled pipelines and tuning results.
#pragma once
#include <optional>

#include "host/drivers/doctor/check.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::doctor {

/// Examines the cache folder, and the files in it for `device` if there is one. Leaves nothing in the folder.
Checks checkCaches(const std::optional<vulkan::DeviceInfo>& device);

}  // namespace candela::doctor
