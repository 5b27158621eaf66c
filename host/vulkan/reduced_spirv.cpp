// Has the optimiser of SPIRV-Tools remove what is never reached.
#include "host/vulkan/reduced_spirv.h"

#include <spirv-tools/optimizer.hpp>
#include <unordered_map>

#include "host/core/errors.h"

namespace candela::vulkan {
namespace {

void registerRemoval(spvtools::Optimizer& optimizer) {
  optimizer.RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
      .RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass());
}

}  // namespace

std::vector<std::uint32_t> reducedSpirv(std::span<const std::uint32_t> spirv,
                                        std::span<const Specialisation> specialisations) {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
  for (const Specialisation& constant : specialisations) values[constant.id] = {constant.value};
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
      .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass());
  // Branches on constants alone are removed first, so that constants are propagated through the functions that remain.
  registerRemoval(optimizer);
  optimizer.RegisterPass(spvtools::CreateCCPPass());
  registerRemoval(optimizer);
  std::string problems;
  optimizer.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
    problems += std::string(" ") + message;
  });
  std::vector<std::uint32_t> reduced;
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  if (!optimizer.Run(spirv.data(), spirv.size(), &reduced, options)) {
    throw InternalError("the SPIR-V optimiser refused a kernel:" + problems);
  }
  return reduced;
}

}  // namespace candela::vulkan
