// Mutations of values.
#include <algorithm>
#include <array>

#include "host/drivers/variants/mutation_kinds.h"

namespace candela::variants {
namespace {

// Operations whose operands may be exchanged.
constexpr std::array kCommutative{kOpIAdd,       kOpFAdd,         kOpIMul,
                                  kOpFMul,       kOpDot,          kOpLogicalOr,
                                  kOpLogicalAnd, kOpLogicalEqual, kOpLogicalNotEqual,
                                  kOpIEqual,     kOpINotEqual,    kOpBitwiseOr,
                                  kOpBitwiseXor, kOpBitwiseAnd};

bool isIn(std::uint32_t opcode, Opcode first, Opcode last) { return opcode >= first && opcode <= last; }

// Returns the comparison with exchanged operands; other operations remain.
std::uint32_t mirrored(std::uint32_t opcode) {
  constexpr std::uint32_t kOfIntegers = kOpULessThan - kOpUGreaterThan,
                          kOfFloats = kOpFOrdGreaterThan - kOpFOrdLessThan;
  if (isIn(opcode, kOpUGreaterThan, kOpSGreaterThanEqual)) return opcode + kOfIntegers;
  if (isIn(opcode, kOpULessThan, kOpSLessThanEqual)) return opcode - kOfIntegers;
  if (opcode == kOpFOrdLessThan || opcode == kOpFUnordLessThan) return opcode + kOfFloats;
  if (opcode == kOpFOrdGreaterThan || opcode == kOpFUnordGreaterThan) return opcode - kOfFloats;
  if (opcode == kOpFOrdLessThanEqual || opcode == kOpFUnordLessThanEqual) return opcode + kOfFloats;
  if (opcode == kOpFOrdGreaterThanEqual || opcode == kOpFUnordGreaterThanEqual) return opcode - kOfFloats;
  return opcode;
}

bool isComparison(std::uint32_t opcode) {
  return isIn(opcode, kOpFOrdEqual, kOpFUnordNotEqual) || mirrored(opcode) != opcode;
}

// Replaces the anchor's result by `replacement` in all instructions after it; the last of these instructions computes
// it.
void replaceResult(Editor& editor, const Anchor& anchor, const std::vector<Instruction>& instructions) {
  const std::size_t index = editor.indexOf(anchor.result) + 1;
  editor.insert(index, instructions);
  editor.replaceUses(index + instructions.size() - 1, anchor.result, instructions.back().result);
}

}  // namespace

bool isScalarOrVector(const Editor& editor, const Anchor& anchor) { return editor.isScalarOrVector(anchor.type); }

bool isCommutative(const Editor&, const Anchor& anchor) {
  return std::ranges::find(kCommutative, anchor.opcode) != kCommutative.end() || isComparison(anchor.opcode);
}

void selectResult(Editor& editor, const Anchor& anchor, std::mt19937& random) {
  Computation always = condition(editor, true, random);
  const std::uint32_t null = editor.nullOf(anchor.type), selected = editor.module().newId();
  always.instructions.push_back(
      buildInstruction(kOpSelect, anchor.type, selected, {{always.result}, {anchor.result}, {null}}));
  replaceResult(editor, anchor, always.instructions);
}

void copyResult(Editor& editor, const Anchor& anchor, std::mt19937&) {
  const std::uint32_t copy = editor.module().newId();
  replaceResult(editor, anchor, {buildInstruction(kOpCopyObject, anchor.type, copy, {{anchor.result}})});
}

void exchangeOperands(Editor& editor, const Anchor& anchor, std::mt19937&) {
  Instruction& one = editor.at(editor.indexOf(anchor.result));
  std::swap(one.words[3], one.words[4]);
  one.opcode = mirrored(one.opcode);
  one.words[0] = (one.words[0] & 0xffff0000u) | one.opcode;
}

}  // namespace candela::variants
