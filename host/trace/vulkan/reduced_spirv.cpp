// Removes unreachable code with the optimiser of SPIRV-Tools.
#include "host/trace/vulkan/reduced_spirv.h"

#include <spirv-tools/optimizer.hpp>
#include <unordered_map>

#include "host/trace/vulkan/run_optimizer.h"

namespace candela::vulkan {
namespace {

void registerFreezing(spvtools::Optimizer& optimizer, std::span<const Specialisation> specialisations) {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
  for (const Specialisation& constant : specialisations) values[constant.id] = {constant.value};
  optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
      .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass());
}

void registerRemoval(spvtools::Optimizer& optimizer) {
  optimizer.RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
      .RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass());
}

}  // namespace

std::vector<std::uint32_t> reducedSpirv(std::span<const std::uint32_t> spirv,
                                        std::span<const Specialisation> specialisations) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  registerFreezing(optimizer, specialisations);
  // Branches on constants are removed first, so that constants are propagated through the functions that remain.
  registerRemoval(optimizer);
  optimizer.RegisterPass(spvtools::CreateCCPPass());
  registerRemoval(optimizer);
  return runOptimizer(optimizer, spirv);
}

std::vector<std::uint32_t> frozenSpirv(std::span<const std::uint32_t> spirv,
                                       std::span<const Specialisation> specialisations) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  registerFreezing(optimizer, specialisations);
  return runOptimizer(optimizer, spirv);
}

}  // namespace candela::vulkan
