// Writes the words of an instruction.
#include "host/drivers/variants/build_instruction.h"

namespace candela::variants {

Instruction buildInstruction(Opcode opcode, std::uint32_t type, std::uint32_t result,
                             std::initializer_list<Operand> operands) {
  Instruction built{opcode, type, result, {0}, {}};
  if (type != 0) built.words.push_back(type);
  if (result != 0) built.words.push_back(result);
  for (const Operand& operand : operands) {
    if (operand.isId) built.idIndices.push_back(static_cast<std::uint16_t>(built.words.size()));
    built.words.push_back(operand.word);
  }
  built.words[0] = (static_cast<std::uint32_t>(built.words.size()) << 16) | opcode;
  return built;
}

}  // namespace candela::variants
