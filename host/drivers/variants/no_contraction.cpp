// Finds floating-point operations, and decorates them.
#include "host/drivers/variants/no_contraction.h"

#include <algorithm>
#include <set>

#include "host/drivers/variants/opcodes.h"

namespace candela::variants {
namespace {

using Ids = std::set<std::uint32_t>;

Ids floatTypes(const Module& module) {
  Ids types;
  for (const Instruction& one : module.instructions) {
    const bool isFloat = one.opcode == kOpTypeFloat;
    const bool isOfFloats = (one.opcode == kOpTypeVector || one.opcode == kOpTypeMatrix) &&
                            types.contains(one.words[2]);
    if (isFloat || isOfFloats) types.insert(one.result);
  }
  return types;
}

bool isArithmetic(std::uint32_t opcode) {
  switch (opcode) {
    case kOpFNegate:
    case kOpFAdd:
    case kOpFSub:
    case kOpFMul:
    case kOpFDiv:
    case kOpFRem:
    case kOpFMod:
      return true;
    default:
      return opcode >= kOpVectorTimesScalar && opcode <= kOpDot;
  }
}

// Functions of GLSL.std.450 that return floats count, too: some of them consist of several operations.
Ids operations(const Module& module) {
  const Ids types = floatTypes(module);
  Ids found;
  for (const Instruction& one : module.instructions) {
    const bool isFunction = one.opcode == kOpExtInst && types.contains(one.type);
    if (isFunction || isArithmetic(one.opcode)) found.insert(one.result);
  }
  return found;
}

bool forbids(const Instruction& one) { return one.opcode == kOpDecorate && one.words[2] == kDecorationNoContraction; }

Ids decoratedIds(const Module& module) {
  Ids decorated;
  for (const Instruction& one : module.instructions) {
    if (forbids(one)) decorated.insert(one.words[1]);
  }
  return decorated;
}

Instruction decoration(std::uint32_t id) {
  return {kOpDecorate, 0, 0, {(3u << 16) | kOpDecorate, id, kDecorationNoContraction}, {1}};
}

}  // namespace

FloatOperations floatOperations(const Module& module) {
  const Ids decorated = decoratedIds(module);
  const Ids all = operations(module);
  return {all.size(), static_cast<std::size_t>(
                          std::ranges::count_if(all, [&](std::uint32_t id) { return decorated.contains(id); }))};
}

void forbidContraction(Module& module) {
  const Ids decorated = decoratedIds(module);
  std::vector<Instruction> added;
  for (const std::uint32_t id : operations(module)) {
    if (!decorated.contains(id)) added.push_back(decoration(id));
  }
  // Every shader has decorations, since its variables have bindings.
  const auto first = std::ranges::find(module.instructions, kOpDecorate, &Instruction::opcode);
  module.instructions.insert(first, added.begin(), added.end());
}

}  // namespace candela::variants
