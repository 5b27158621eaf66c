// The probe of the loop limit reports the behaviour of the device.
#include "host/trace/vulkan/loop_limit.h"

#include <catch2/catch.hpp>

#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::vulkan;

TEST_CASE("a device runs every iteration of a loop, or the probe reports their number") {
  vulkan::Device device = openTestDevice();
  const std::uint32_t limit = vulkan::probeLoopLimit(device);
  WARN(device.info().name << ": " << (limit == vulkan::kUnlimitedIterations ? "unlimited" : std::to_string(limit)));
  const bool isUnlimited = limit == vulkan::kUnlimitedIterations;
  CHECK((isUnlimited || limit < (1u << 20)));
  CHECK(limit > 1000);
  CHECK(vulkan::probeLoopLimit(device) == limit);
}

TEST_CASE("SwiftShader has no loop limit, and lavapipe of Mesa 22 stops after 65,535 iterations") {
  vulkan::Device device = openTestDevice();
  const std::string driver = device.info().driver;
  if (driver.find("SwiftShader") != std::string::npos)
    CHECK(vulkan::probeLoopLimit(device) == vulkan::kUnlimitedIterations);
  if (driver.find("Mesa 22.") != std::string::npos) CHECK(vulkan::probeLoopLimit(device) == 65535);
}
