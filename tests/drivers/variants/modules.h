// Modules that the tests of variants change.
#pragma once
#include <span>
#include <spirv-tools/libspirv.hpp>
#include <string>
#include <vector>

#include "host/drivers/variants/module.h"
#include "host/trace/vulkan/reduced_spirv.h"
#include "spirv/control.h"
#include "spirv/memory.h"
#include "spirv/path.h"
#include "spirv/views.h"
#include "spirv/wave_extend.h"
#include "spirv/wave_renew.h"
#include "spirv/wave_shade.h"
#include "spirv/whitted.h"

namespace candela::variants {

struct NamedModule {
  const char* name;
  std::span<const std::uint32_t> spirv;
};

inline std::vector<NamedModule> testModules() {
  return {{"path", spirv::path},
          {"views", spirv::views},
          {"whitted", spirv::whitted},
          {"wave_extend", spirv::wave_extend},
          {"wave_shade", spirv::wave_shade},
          {"control", spirv::control},
          {"memory", spirv::memory}};
}

/// Returns the modules that take little time.
inline std::vector<NamedModule> smallModules() {
  return {{"wave_renew", spirv::wave_renew}, {"control", spirv::control}};
}

/// Returns the message of the validator about a module; empty: it is valid.
inline std::string validationOf(const Code& code) {
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_2);
  std::string problems;
  tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
    problems += std::string(message) + "\n";
  });
  return tools.Validate(code) ? std::string() : "invalid: " + problems;
}

}  // namespace candela::variants
