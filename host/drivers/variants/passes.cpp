// Calls the optimiser of SPIRV-Tools.
#include "host/drivers/variants/passes.h"

#include <spirv-tools/optimizer.hpp>

#include "host/base/errors.h"
#include "host/trace/vulkan/run_optimizer.h"

namespace candela::variants {
namespace {

std::vector<std::string> namesOf(const spvtools::Optimizer& optimizer) {
  const std::vector<const char*> names = optimizer.GetPassNames();
  return {names.begin(), names.end()};
}

}  // namespace

std::vector<std::string> performancePasses() {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  return namesOf(optimizer.RegisterPerformancePasses());
}

std::vector<std::string> sizePasses() {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  return namesOf(optimizer.RegisterSizePasses());
}

Code optimised(std::span<const std::uint32_t> code, const std::vector<std::string>& passes) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  for (const std::string& pass : passes) {
    if (!optimizer.RegisterPassFromFlag("--" + pass)) throw InternalError("SPIRV-Tools has no pass " + pass);
  }
  return vulkan::runOptimizer(optimizer, code);
}

}  // namespace candela::variants
