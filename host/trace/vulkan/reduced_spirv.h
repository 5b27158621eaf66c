// SPIR-V whose specialisation constants are set to their values.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/trace/vulkan/compute_pipeline.h"

namespace candela::vulkan {

/// Returns the module with the constants at their values, and without unreachable branches and functions.
/// Drivers then do not compile code that a scene does not use, which takes some of them seconds, minutes or gigabytes:
/// docs/driver-workarounds.md section 10. Arithmetic on the values of a scene is untouched. Throws InternalError if the
/// optimiser refuses the module.
std::vector<std::uint32_t> reducedSpirv(std::span<const std::uint32_t> spirv,
                                        std::span<const Specialisation> specialisations);

/// Returns the module with the constants at their values. Throws as reducedSpirv() does.
std::vector<std::uint32_t> frozenSpirv(std::span<const std::uint32_t> spirv,
                                       std::span<const Specialisation> specialisations);

}  // namespace candela::vulkan
