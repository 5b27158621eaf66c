// The validation layer is enabled on request, reports wrong calls, and is reported if it is missing.
#include "host/trace/vulkan/validation.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "spirv/combine.h"
#include "tests/trace/vulkan/environment_guard.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::vulkan;
using Catch::Matchers::Contains;
using vulkan::BindingKind;
using vulkan::ComputePipeline;

TEST_CASE("a wrong call is in the validation log until it is cleared") {
  const EnvironmentGuard validation("CANDELA_VALIDATION", "1");
  vulkan::Device device = openTestDevice();
  REQUIRE(vulkan::validationMessages().empty());
  const ComputePipeline withTooFewBindings(  // the shader has three
      device, spirv::combine, {.bindings = {BindingKind::uniformTexelBuffer}, .pushConstantBytes = 8});
  const std::vector<std::string> messages = vulkan::validationMessages();
  REQUIRE_FALSE(messages.empty());
  CHECK_THAT(messages.front(), Contains("VUID-VkComputePipelineCreateInfo-layout-"));
  vulkan::clearValidationMessages();
  CHECK(vulkan::validationMessages().empty());
}

TEST_CASE("validation is requested by any value except 0 and the empty one") {
  const auto isRequested = [](const char* value) {
    const EnvironmentGuard guard("CANDELA_VALIDATION", value);
    return vulkan::validationRequested();
  };
  CHECK(isRequested("1"));
  CHECK_FALSE(isRequested("0"));
  CHECK_FALSE(isRequested(""));
}

TEST_CASE("requesting validation without the layer is an error that names it") {
  const EnvironmentGuard validation("CANDELA_VALIDATION", "1");
  const EnvironmentGuard path("VK_LAYER_PATH", "/nonexistent");
  CHECK_THROWS_AS(openTestDevice(), NoDeviceError);
  CHECK_THROWS_WITH(openTestDevice(), Contains("apt-get install vulkan-validationlayers"));
}
