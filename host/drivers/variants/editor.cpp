// Finds and adds parts of a module.
#include "host/drivers/variants/editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "host/base/errors.h"

namespace candela::variants {
namespace {

auto positionOf(std::vector<Instruction>& instructions, std::size_t index) {
  return instructions.begin() + static_cast<std::ptrdiff_t>(index);
}

// Indices of labels that the phi instructions of a function name.
void renameParent(Instruction& phi, std::uint32_t from, std::uint32_t to) {
  constexpr std::size_t kFirstParent = 4;
  for (std::size_t i = kFirstParent; i < phi.words.size(); i += 2) {
    if (phi.words[i] == from) phi.words[i] = to;
  }
}

}  // namespace

void Editor::insert(std::size_t index, const std::vector<Instruction>& instructions) {
  module_.instructions.insert(positionOf(module_.instructions, index), instructions.begin(), instructions.end());
}

std::size_t Editor::indexOf(std::uint32_t result) const {
  const auto found = std::ranges::find(module_.instructions, result, &Instruction::result);
  if (found == module_.instructions.end()) throw InternalError(fmt::format("the module has no %{}", result));
  return static_cast<std::size_t>(found - module_.instructions.begin());
}

std::size_t Editor::before(std::size_t index, Opcode opcode) const {
  for (std::size_t i = index + 1; i-- > 0;) {
    if (module_.instructions[i].opcode == opcode) return i;
  }
  throw InternalError(fmt::format("the module has no instruction {} before {}", static_cast<unsigned>(opcode), index));
}

std::vector<std::uint32_t> Editor::localVariables(std::size_t index) const {
  std::vector<std::uint32_t> ids;
  for (std::size_t i = before(index, kOpFunction); module_.instructions[i].opcode != kOpFunctionEnd; ++i) {
    if (module_.instructions[i].opcode == kOpVariable) ids.push_back(module_.instructions[i].result);
  }
  return ids;
}

std::uint32_t Editor::declare(Opcode opcode, std::uint32_t type, std::initializer_list<Operand> operands) {
  Instruction declared = buildInstruction(opcode, type, module_.header[3], operands);
  const std::size_t first = type == 0 ? 1 : 2;  // word of the result
  const auto isEqual = [&](const Instruction& one) {
    return one.opcode == opcode && one.type == type && one.words.size() == declared.words.size() &&
           std::equal(one.words.begin() + first + 1, one.words.end(), declared.words.begin() + first + 1);
  };
  const auto found = std::ranges::find_if(module_.instructions, isEqual);
  if (found != module_.instructions.end()) return found->result;
  const auto function = std::ranges::find(module_.instructions, kOpFunction, &Instruction::opcode);
  module_.instructions.insert(function, declared);
  return module_.newId();
}

std::uint32_t Editor::boolType() { return declare(kOpTypeBool, 0, {}); }
std::uint32_t Editor::uintType() { return declare(kOpTypeInt, 0, {literal(32), literal(0)}); }

std::uint32_t Editor::boolConstant(bool value) {
  return declare(value ? kOpConstantTrue : kOpConstantFalse, boolType(), {});
}

std::uint32_t Editor::uintConstant(std::uint32_t value) { return declare(kOpConstant, uintType(), {literal(value)}); }
std::uint32_t Editor::nullOf(std::uint32_t type) { return declare(kOpConstantNull, type, {}); }

std::uint32_t Editor::pointee(std::uint32_t variable) const {
  const std::uint32_t pointer = module_.instructions[indexOf(variable)].type;
  return module_.instructions[indexOf(pointer)].words[3];
}

bool Editor::isScalarOrVector(std::uint32_t type) const {
  const std::uint32_t opcode = module_.instructions[indexOf(type)].opcode;
  return opcode >= kOpTypeBool && opcode <= kOpTypeVector;
}

Computation Editor::invocationX() {
  const auto isInvocation = [](const Instruction& one) {
    return one.opcode == kOpDecorate && one.words[2] == kDecorationBuiltIn &&
           one.words[3] == kBuiltInGlobalInvocationId;
  };
  const auto found = std::ranges::find_if(module_.instructions, isInvocation);
  if (found == module_.instructions.end()) return {{}, uintConstant(1)};
  const std::uint32_t variable = found->words[1];
  const std::uint32_t vector = module_.newId(), x = module_.newId();
  return {{buildInstruction(kOpLoad, pointee(variable), vector, {{variable}}),
           buildInstruction(kOpCompositeExtract, uintType(), x, {{vector}, literal(0)})},
          x};
}

std::uint32_t Editor::splitBlock(std::size_t index) {
  const std::uint32_t label = at(before(index, kOpLabel)).result, next = module_.newId();
  for (std::size_t i = index; at(i).opcode != kOpFunctionEnd; ++i) {
    if (at(i).opcode == kOpPhi) renameParent(at(i), label, next);
  }
  for (std::size_t i = index; at(i).opcode != kOpFunction; --i) {
    if (at(i).opcode == kOpPhi) renameParent(at(i), label, next);
  }
  insert(index, {buildInstruction(kOpBranch, 0, 0, {{next}}), buildInstruction(kOpLabel, 0, next, {})});
  return next;
}

void Editor::replaceUses(std::size_t index, std::uint32_t id, std::uint32_t with) {
  for (std::size_t i = index + 1; i < module_.instructions.size(); ++i) {
    for (const std::uint16_t word : at(i).idIndices) {
      if (at(i).words[word] == id) at(i).words[word] = with;
    }
  }
}

}  // namespace candela::variants
