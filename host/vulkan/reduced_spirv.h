// SPIR-V without the code that specialisation constants disable.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/vulkan/compute_pipeline.h"

namespace candela::vulkan {

/// Returns whether this driver (DeviceInfo::driver) compiles code that is never reached, which takes it minutes and
/// gigabytes for a path tracer with all features: docs/driver-workarounds.md section 10.
bool compilesDisabledCode(const std::string& driver);

/// Returns the module with the constants at their values, and without branches and functions that are never reached.
/// Arithmetic is untouched. Throws InternalError if the optimiser refuses the module.
std::vector<std::uint32_t> reducedSpirv(std::span<const std::uint32_t> spirv,
                                        std::span<const Specialisation> specialisations);

}  // namespace candela::vulkan
