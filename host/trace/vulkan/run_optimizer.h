// Runs the optimiser of SPIRV-Tools.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace spvtools {
class Optimizer;
}

namespace candela::vulkan {

/// Returns the module that the registered passes make, without validating it. Throws InternalError, with the
/// optimiser's messages, if it refuses the module.
std::vector<std::uint32_t> runOptimizer(spvtools::Optimizer& optimizer, std::span<const std::uint32_t> spirv);

}  // namespace candela::vulkan
