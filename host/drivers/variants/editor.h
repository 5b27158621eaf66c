// Finds and adds parts of a module.
#pragma once
#include <string>

#include "host/drivers/variants/build_instruction.h"

namespace candela::variants {

/// Instructions that compute a value.
struct Computation {
  std::vector<Instruction> instructions;
  std::uint32_t result = 0;
};

/// Indices are those of Module::instructions. They change when instructions are added, also to the declarations of
/// types and constants: find an index after these.
class Editor {
 public:
  explicit Editor(Module& module) : module_(module) {}

  Module& module() { return module_; }
  Instruction& at(std::size_t index) { return module_.instructions[index]; }
  void insert(std::size_t index, const std::vector<Instruction>& instructions);

  /// Returns the index of the instruction with a result. Throws InternalError if there is none.
  std::size_t indexOf(std::uint32_t result) const;
  /// Returns the index of the nearest instruction with an opcode at `index` or before it. Throws InternalError.
  std::size_t before(std::size_t index, Opcode opcode) const;
  /// Returns the ids of the local variables of the function that contains `index`.
  std::vector<std::uint32_t> localVariables(std::size_t index) const;

  // Ids of types and constants, which are added to the module if it does not declare them.
  std::uint32_t boolType();
  std::uint32_t uintType();
  std::uint32_t boolConstant(bool value);
  std::uint32_t uintConstant(std::uint32_t value);
  std::uint32_t nullOf(std::uint32_t type);
  /// Returns the type to which a variable or a pointer refers.
  std::uint32_t pointee(std::uint32_t variable) const;
  /// Returns whether values of a type are scalars or vectors.
  bool isScalarOrVector(std::uint32_t type) const;

  /// Computes the x coordinate of the invocation; a constant in modules that do not use gl_GlobalInvocationID.
  Computation invocationX();

  /// Divides a block before `index`, which becomes the first instruction of a new block, by a branch. Values that reach
  /// other blocks through phi instructions come from the new block. Returns the id of the new block's label.
  std::uint32_t splitBlock(std::size_t index);

  /// Replaces `id` by `with` in all instructions after `index`.
  void replaceUses(std::size_t index, std::uint32_t id, std::uint32_t with);

 private:
  std::uint32_t declare(Opcode opcode, std::uint32_t type, std::initializer_list<Operand> operands);

  Module& module_;
};

}  // namespace candela::variants
