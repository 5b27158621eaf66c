// Arithmetic that compilers must not contract, so that every correct form of a module computes the same bits.
#pragma once
#include "host/drivers/variants/module.h"

namespace candela::variants {

/// Number of floating-point operations of a module.
struct FloatOperations {
  std::size_t all = 0;
  std::size_t decorated = 0;  ///< those with the decoration NoContraction
};

FloatOperations floatOperations(const Module& module);

/// Decorates all floating-point operations with NoContraction.
void forbidContraction(Module& module);

}  // namespace candela::variants
