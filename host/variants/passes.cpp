// Calls the optimiser of SPIRV-Tools.
#include "host/variants/passes.h"

#include <spirv-tools/optimizer.hpp>

#include "host/core/errors.h"

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
  std::string problems;
  optimizer.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
    problems += std::string(" ") + message;
  });
  for (const std::string& pass : passes) {
    if (!optimizer.RegisterPassFromFlag("--" + pass)) throw InternalError("SPIRV-Tools has no pass " + pass);
  }
  Code result;
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  if (!optimizer.Run(code.data(), code.size(), &result, options)) {
    throw InternalError("the SPIR-V optimiser refused a shader:" + problems);
  }
  return result;
}

}  // namespace candela::variants
