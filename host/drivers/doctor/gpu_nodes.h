// Finds GPUs that the kernel lists but no Vulkan driver supports.
#pragma once
#include <filesystem>

#include "host/drivers/doctor/check.h"

namespace candela::doctor {

/// Examines the device files of GPUs in `folder` (/dev). `gpuListed`: a Vulkan driver lists a device in hardware.
Checks checkGpuNodes(const std::filesystem::path& folder, bool gpuListed);

}  // namespace candela::doctor
