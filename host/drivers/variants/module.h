// A SPIR-V module as a list of instructions that can be changed and written again.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candela::variants {

/// The words of a SPIR-V module.
using Code = std::vector<std::uint32_t>;

struct Instruction {
  std::uint32_t opcode = 0;              ///< of the SPIR-V specification: opcodes.h
  std::uint32_t type = 0;                ///< id of the type of the result; 0: none
  std::uint32_t result = 0;              ///< id; 0: none
  std::vector<std::uint32_t> words;      ///< all words, the first of which has the length and the opcode
  std::vector<std::uint16_t> idIndices;  ///< indices of the words that are ids, except for `type` and `result`
};

struct Module {
  std::array<std::uint32_t, 5> header{};
  std::vector<Instruction> instructions;

  /// Returns an id that is not in use.
  std::uint32_t newId() { return header[3]++; }
};

/// Throws InternalError if `code` is not valid SPIR-V for Vulkan 1.2.
Module parseModule(std::span<const std::uint32_t> code);

Code codeOf(const Module& module);

}  // namespace candela::variants
