// The optimiser's passes.
#include "host/drivers/variants/passes.h"

#include <catch2/catch.hpp>
#include <spirv-tools/optimizer.hpp>

#include "tests/drivers/variants/modules.h"

namespace candela::variants {
namespace {

Code optimisedAtOnce(std::span<const std::uint32_t> code, const char* flag) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  REQUIRE(optimizer.RegisterPassFromFlag(flag));
  Code result;
  REQUIRE(optimizer.Run(code.data(), code.size(), &result));
  return result;
}

}  // namespace

TEST_CASE("variants: the passes of -O and -Os, run by their names, have the results of the options") {
  CHECK(optimised(spirv::control, performancePasses()) == optimisedAtOnce(spirv::control, "-O"));
  CHECK(optimised(spirv::control, sizePasses()) == optimisedAtOnce(spirv::control, "-Os"));
}

TEST_CASE("variants: unknown passes and broken modules are refused") {
  CHECK_THROWS_WITH(optimised(spirv::control, {"no-such-pass"}), "SPIRV-Tools has no pass no-such-pass");
  CHECK_THROWS_WITH(parseModule(Code{1, 2, 3}), Catch::Contains("not valid SPIR-V"));
}

}  // namespace candela::variants
