// Finds GPUs that the kernel knows but no Vulkan driver uses.
#pragma once
#include <filesystem>

#include "host/doctor/check.h"

namespace candela::doctor {

/// Examines the device files of GPUs in `folder` (/dev). `gpuListed`: a Vulkan driver lists a device in hardware.
Checks checkGpuNodes(const std::filesystem::path& folder, bool gpuListed);

}  // namespace candela::doctor
