// Collects the messages of the optimiser.
#include "host/trace/vulkan/run_optimizer.h"

#include <spirv-tools/optimizer.hpp>
#include <string>

#include "host/base/errors.h"

namespace candela::vulkan {

std::vector<std::uint32_t> runOptimizer(spvtools::Optimizer& optimizer, std::span<const std::uint32_t> spirv) {
  std::string problems;
  optimizer.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
    problems += std::string(" ") + message;
  });
  std::vector<std::uint32_t> result;
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  if (!optimizer.Run(spirv.data(), spirv.size(), &result, options)) {
    throw InternalError("the SPIR-V optimiser refused a shader:" + problems);
  }
  return result;
}

}  // namespace candela::vulkan
