// Numbers of the SPIR-V specification, sections 3.20 (decorations) and 3.49 (instructions).
#pragma once
#include <cstdint>

namespace candela::variants {

enum Opcode : std::uint32_t {
  kOpExtInst = 12,
  kOpTypeFloat = 22,
  kOpTypeVector = 23,
  kOpTypeMatrix = 24,
  kOpDecorate = 71,
  kOpFNegate = 127,
  kOpFAdd = 129,
  kOpFSub = 131,
  kOpFMul = 133,
  kOpFDiv = 136,
  kOpFRem = 140,
  kOpFMod = 141,
  kOpVectorTimesScalar = 142,
  kOpDot = 148,
};

inline constexpr std::uint32_t kNoContraction = 42;

}  // namespace candela::variants
