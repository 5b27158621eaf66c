// Numbers of the SPIR-V specification: instructions (section 3.49), decorations (3.20) and masks.
#pragma once
#include <cstdint>

namespace candela::variants {

enum Opcode : std::uint32_t {
  kOpExtInst = 12,
  kOpTypeBool = 20,
  kOpTypeInt = 21,
  kOpTypeFloat = 22,
  kOpTypeVector = 23,
  kOpTypeMatrix = 24,
  kOpTypePointer = 32,
  kOpConstantTrue = 41,
  kOpConstantFalse = 42,
  kOpConstant = 43,
  kOpConstantNull = 46,
  kOpFunction = 54,
  kOpFunctionEnd = 56,
  kOpVariable = 59,
  kOpLoad = 61,
  kOpStore = 62,
  kOpDecorate = 71,
  kOpCompositeExtract = 81,
  kOpCopyObject = 83,
  kOpConvertFToU = 109,
  kOpBitcast = 124,
  kOpSNegate = 126,
  kOpFNegate = 127,
  kOpIAdd = 128,
  kOpFAdd = 129,
  kOpFSub = 131,
  kOpIMul = 132,
  kOpFMul = 133,
  kOpFDiv = 136,
  kOpFRem = 140,
  kOpFMod = 141,
  kOpVectorTimesScalar = 142,
  kOpDot = 148,
  kOpLogicalEqual = 164,
  kOpLogicalNotEqual = 165,
  kOpLogicalOr = 166,
  kOpLogicalAnd = 167,
  kOpSelect = 169,
  kOpIEqual = 170,
  kOpINotEqual = 171,
  kOpUGreaterThan = 172,
  kOpSGreaterThanEqual = 175,
  kOpULessThan = 176,
  kOpSLessThanEqual = 179,
  kOpFOrdEqual = 180,
  kOpFUnordNotEqual = 183,
  kOpFOrdLessThan = 184,
  kOpFUnordLessThan = 185,
  kOpFOrdGreaterThan = 186,
  kOpFUnordGreaterThan = 187,
  kOpFOrdLessThanEqual = 188,
  kOpFUnordLessThanEqual = 189,
  kOpFOrdGreaterThanEqual = 190,
  kOpFUnordGreaterThanEqual = 191,
  kOpBitwiseOr = 197,
  kOpBitwiseXor = 198,
  kOpBitwiseAnd = 199,
  kOpNot = 200,
  kOpControlBarrier = 224,
  kOpPhi = 245,
  kOpLoopMerge = 246,
  kOpSelectionMerge = 247,
  kOpLabel = 248,
  kOpBranch = 249,
  kOpBranchConditional = 250,
  kOpSwitch = 251,
  kOpUnreachable = 255,
};

inline constexpr std::uint32_t kDecorationBuiltIn = 11;
inline constexpr std::uint32_t kDecorationNoContraction = 42;
inline constexpr std::uint32_t kBuiltInGlobalInvocationId = 28;
inline constexpr std::uint32_t kLoopUnroll = 1;
inline constexpr std::uint32_t kLoopDontUnroll = 2;

}  // namespace candela::variants
