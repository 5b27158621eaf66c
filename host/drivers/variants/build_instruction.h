// Makes instructions.
#pragma once
#include <initializer_list>

#include "host/drivers/variants/module.h"
#include "host/drivers/variants/opcodes.h"

namespace candela::variants {

/// An operand after the type and the result.
struct Operand {
  std::uint32_t word = 0;
  bool isId = true;
};

constexpr Operand literal(std::uint32_t word) { return {word, false}; }

/// `type` and `result`: 0 for none.
Instruction buildInstruction(Opcode opcode, std::uint32_t type, std::uint32_t result,
                             std::initializer_list<Operand> operands);

}  // namespace candela::variants
