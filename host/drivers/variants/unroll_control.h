// The loop control without which spirv-opt unrolls no loop.
#pragma once
#include "host/drivers/variants/module.h"

namespace candela::variants {

/// Requests of every loop that it be unrolled. Returns the number of loops.
std::size_t requestUnrolling(Module& module);

}  // namespace candela::variants
