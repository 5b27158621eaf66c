// Passes of the optimiser of SPIRV-Tools, with their names in spirv-opt.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "host/drivers/variants/module.h"

namespace candela::variants {

/// The passes of `spirv-opt -O`, in their order.
std::vector<std::string> performancePasses();
/// The passes of `spirv-opt -Os`, in their order.
std::vector<std::string> sizePasses();

/// Runs passes such as "ccp" or "scalar-replacement=100". Throws InternalError if the library has no such pass, or
/// refuses the module.
Code optimised(std::span<const std::uint32_t> code, const std::vector<std::string>& passes);

}  // namespace candela::variants
