// Mutations of control flow.
#include <algorithm>
#include <map>

#include "host/drivers/variants/mutation_kinds.h"

namespace candela::variants {
namespace {

constexpr std::size_t kMaxRepeated = 3, kMaxWrapped = 8;

Instruction label(std::uint32_t id) { return buildInstruction(kOpLabel, 0, id, {}); }
Instruction branchTo(std::uint32_t id) { return buildInstruction(kOpBranch, 0, 0, {{id}}); }

bool isPure(const Instruction& one) { return one.opcode >= kOpConvertFToU && one.opcode <= kOpNot; }

// Copies of the arithmetic before `index` in its block. Nothing uses their results.
std::vector<Instruction> repeatedCode(Editor& editor, std::size_t index) {
  std::vector<Instruction> repeated;
  for (std::size_t i = index; repeated.size() < kMaxRepeated && editor.at(--i).opcode != kOpLabel;) {
    if (!isPure(editor.at(i))) continue;
    Instruction copy = editor.at(i);
    copy.words[2] = copy.result = editor.module().newId();
    repeated.insert(repeated.begin(), copy);
  }
  return repeated;
}

// The words of a store that destroys a local variable, if there is one.
std::vector<Instruction> overwrittenVariable(Editor& editor, const Anchor& anchor, std::mt19937& random) {
  const std::vector<std::uint32_t> variables = editor.localVariables(editor.indexOf(anchor.result));
  if (variables.empty()) return {};
  const std::uint32_t variable = variables[random() % variables.size()];
  return {buildInstruction(kOpStore, 0, 0, {{variable}, {editor.nullOf(editor.pointee(variable))}})};
}

void append(std::vector<Instruction>& code, const std::vector<Instruction>& more) {
  code.insert(code.end(), more.begin(), more.end());
}

// Replaces the branch at `index`, the end of a block, by one that depends on a condition.
void branchConditionally(Editor& editor, std::size_t index, const Computation& condition, std::uint32_t merge,
                         std::uint32_t ifTrue, std::uint32_t ifFalse) {
  std::vector<Instruction> code = condition.instructions;
  code.push_back(buildInstruction(kOpSelectionMerge, 0, 0, {{merge}, literal(0)}));
  code.push_back(buildInstruction(kOpBranchConditional, 0, 0, {{condition.result}, {ifTrue}, {ifFalse}}));
  editor.module().instructions.erase(editor.module().instructions.begin() + static_cast<std::ptrdiff_t>(index));
  editor.insert(index, code);
}

// Computes whether the x coordinate of the invocation is even.
Computation isEven(Editor& editor) {
  Computation x = editor.invocationX();
  const std::uint32_t one = editor.uintConstant(1), zero = editor.uintConstant(0), uint = editor.uintType(),
                      boolean = editor.boolType();
  const std::uint32_t bit = editor.module().newId(), result = editor.module().newId();
  append(x.instructions, {buildInstruction(kOpBitwiseAnd, uint, bit, {{x.result}, {one}}),
                          buildInstruction(kOpIEqual, boolean, result, {{bit}, {zero}})});
  return {x.instructions, result};
}

bool canBeWrapped(const Instruction& one) {
  return one.opcode != kOpControlBarrier && (one.opcode < kOpPhi || one.opcode > kOpUnreachable);
}

std::size_t wrappedCount(Editor& editor, std::size_t index) {
  std::size_t count = 0;
  while (count < kMaxWrapped && canBeWrapped(editor.at(index + count))) ++count;
  return count;
}

}  // namespace

Computation condition(Editor& editor, bool value, std::mt19937& random) {
  const auto choice = random() % 3;
  if (choice == 0) return {{}, editor.boolConstant(value)};
  Computation x = editor.invocationX();
  const std::uint32_t uint = editor.uintType(), boolean = editor.boolType(), zero = editor.uintConstant(0),
                      one = editor.uintConstant(1), two = editor.uintConstant(2);
  const std::uint32_t word = editor.module().newId(), result = editor.module().newId();
  if (choice == 1) {  // x | 1 is not 0
    append(x.instructions, {buildInstruction(kOpBitwiseOr, uint, word, {{x.result}, {one}}),
                            buildInstruction(value ? kOpINotEqual : kOpIEqual, boolean, result, {{word}, {zero}})});
  } else {  // a square leaves the remainder 0 or 1 when divided by 4
    const std::uint32_t square = editor.module().newId();
    append(x.instructions, {buildInstruction(kOpIMul, uint, square, {{x.result}, {x.result}}),
                            buildInstruction(kOpBitwiseAnd, uint, word, {{square}, {two}}),
                            buildInstruction(value ? kOpIEqual : kOpINotEqual, boolean, result, {{word}, {zero}})});
  }
  return {x.instructions, result};
}

bool isPossibleAnywhere(const Editor&, const Anchor&) { return true; }

void splitAtAnchor(Editor& editor, const Anchor& anchor, std::mt19937&) {
  editor.splitBlock(editor.indexOf(anchor.result));
}

void addDeadBranch(Editor& editor, const Anchor& anchor, std::mt19937& random) {
  const bool isTaken = random() % 2 == 0;
  const Computation taken = condition(editor, isTaken, random);
  const std::vector<Instruction> store = overwrittenVariable(editor, anchor, random);
  const std::size_t index = editor.indexOf(anchor.result);
  std::vector<Instruction> dead = repeatedCode(editor, index);
  const std::uint32_t merge = editor.splitBlock(index), deadLabel = editor.module().newId();
  append(dead, store);
  dead.insert(dead.begin(), label(deadLabel));
  dead.push_back(branchTo(merge));
  editor.insert(index + 1, dead);
  branchConditionally(editor, index, taken, merge, isTaken ? merge : deadLabel, isTaken ? deadLabel : merge);
}

void addBranchWithoutEffect(Editor& editor, const Anchor& anchor, std::mt19937&) {
  const Computation even = isEven(editor);
  const bool hasValue = editor.isScalarOrVector(anchor.type);
  const std::size_t index = editor.indexOf(anchor.result) + 1;  // after the anchor
  const std::vector<Instruction> repeated = repeatedCode(editor, index);
  const std::uint32_t merge = editor.splitBlock(index), first = editor.module().newId(),
                      second = editor.module().newId(), value = editor.module().newId();
  std::vector<Instruction> sides{label(first), branchTo(merge), label(second)};
  append(sides, repeated);
  sides.push_back(branchTo(merge));
  if (hasValue) {
    const std::size_t behindLabel = index + 2;
    editor.insert(behindLabel, {buildInstruction(kOpPhi, anchor.type, value,
                                                 {{anchor.result}, {first}, {anchor.result}, {second}})});
    editor.replaceUses(behindLabel, anchor.result, value);
  }
  editor.insert(index + 1, sides);
  branchConditionally(editor, index, even, merge, first, second);
}

void wrapInLoop(Editor& editor, const Anchor& anchor, std::mt19937& random) {
  const Computation again = condition(editor, false, random);
  const std::size_t index = editor.indexOf(anchor.result);
  const std::size_t count = wrappedCount(editor, index);
  const std::uint32_t merge = editor.splitBlock(index + count);
  const std::uint32_t body = editor.splitBlock(index), header = editor.module().newId(), end = editor.module().newId();
  // After the body: its branch to `merge` becomes one to `end`.
  const std::size_t bodyEnd = index + 2 + count;
  std::vector<Instruction> tail{branchTo(end), label(end)};
  append(tail, again.instructions);
  tail.push_back(buildInstruction(kOpBranchConditional, 0, 0, {{again.result}, {header}, {merge}}));
  editor.module().instructions.erase(editor.module().instructions.begin() + static_cast<std::ptrdiff_t>(bodyEnd));
  editor.insert(bodyEnd, tail);
  editor.at(index) = branchTo(header);
  editor.insert(index + 1,
                {label(header), buildInstruction(kOpLoopMerge, 0, 0, {{merge}, {end}, literal(0)}), branchTo(body)});
}

}  // namespace candela::variants
