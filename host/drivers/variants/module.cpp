// Divides a module by the parser of SPIRV-Tools.
#include "host/drivers/variants/module.h"

#include <memory>
#include <spirv-tools/libspirv.hpp>

#include "host/base/errors.h"

namespace candela::variants {
namespace {

constexpr std::uint32_t kMagic = 0x07230203;

bool isId(spv_operand_type_t type) {
  return type == SPV_OPERAND_TYPE_ID || type == SPV_OPERAND_TYPE_SCOPE_ID ||
         type == SPV_OPERAND_TYPE_MEMORY_SEMANTICS_ID;
}

spv_result_t takeHeader(void* user, spv_endianness_t, std::uint32_t, std::uint32_t version, std::uint32_t generator,
                        std::uint32_t bound, std::uint32_t schema) {
  static_cast<Module*>(user)->header = {kMagic, version, generator, bound, schema};
  return SPV_SUCCESS;
}

spv_result_t takeInstruction(void* user, const spv_parsed_instruction_t* parsed) {
  Instruction taken{parsed->opcode, parsed->type_id, parsed->result_id, {}, {}};
  taken.words.assign(parsed->words, parsed->words + parsed->num_words);
  for (const spv_parsed_operand_t& operand : std::span(parsed->operands, parsed->num_operands)) {
    if (isId(operand.type)) taken.idIndices.push_back(operand.offset);
  }
  static_cast<Module*>(user)->instructions.push_back(std::move(taken));
  return SPV_SUCCESS;
}

}  // namespace

Module parseModule(std::span<const std::uint32_t> code) {
  const std::unique_ptr<spv_context_t, void (*)(spv_context)> context(spvContextCreate(SPV_ENV_VULKAN_1_2),
                                                                      spvContextDestroy);
  Module module;
  if (spvBinaryParse(context.get(), &module, code.data(), code.size(), takeHeader, takeInstruction, nullptr) !=
      SPV_SUCCESS) {
    throw InternalError("a shader is not valid SPIR-V for Vulkan 1.2");
  }
  return module;
}

Code codeOf(const Module& module) {
  Code code(module.header.begin(), module.header.end());
  for (const Instruction& one : module.instructions) code.insert(code.end(), one.words.begin(), one.words.end());
  return code;
}

}  // namespace candela::variants
