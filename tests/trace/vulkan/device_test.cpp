// Devices are found, described, selected and opened; without any, the message says so.
#include "host/trace/vulkan/device.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/trace/vulkan/device_info.h"
#include "tests/trace/vulkan/environment_guard.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::vulkan;
using Catch::Matchers::Contains;
using vulkan::Device;

TEST_CASE("a usable device is described with limits that Vulkan guarantees") {
  const DeviceInfo info = openTestDevice().info();
  CAPTURE(info.name, info.driver);
  CHECK(info.usable);
  CHECK(info.whyNot.empty());
  CHECK_FALSE(info.name.empty());
  CHECK_FALSE(info.driver.empty());
  CHECK_THAT(info.apiVersion, Catch::Matchers::StartsWith("1."));
  CHECK(info.memoryBytes > 0);
  CHECK(info.maxStorageBufferRange >= std::uint64_t{1} << 27);
  CHECK(info.maxTexelBufferElements >= 65536);
  CHECK(info.maxWorkgroupInvocations >= 128);
  CHECK(info.maxWorkgroupSize[0] >= 128);
  CHECK(info.maxWorkgroupSize[1] >= 128);
  CHECK(info.maxWorkgroupSize[2] >= 64);
  CHECK(info.subgroupSize >= 1);
}

TEST_CASE("devices are numbered in order, and each is opened by its index or its description") {
  const std::vector<DeviceInfo> infos = listDevices();
  REQUIRE_FALSE(infos.empty());
  for (std::uint32_t i = 0; i < infos.size(); ++i) {
    CHECK(infos[i].index == i);
    if (!infos[i].usable) continue;
    CHECK(selectDevice(std::to_string(i)).name == infos[i].name);
    CHECK(Device::open(std::to_string(i)).info().name == infos[i].name);
    CHECK(Device::open(infos[i]).info().index == i);
  }
}

TEST_CASE("a device that does not exist is refused with the existing ones") {
  CHECK_THROWS_AS(selectDevice("no such device"), NoDeviceError);
  CHECK_THROWS_AS(Device::open("no such device"), NoDeviceError);
  CHECK_THROWS_WITH(selectDevice("no such device"), Contains("0: " + listDevices()[0].name));
}

TEST_CASE("a device that has changed since it was listed is not opened") {
  DeviceInfo info = listDevices().at(0);
  info.name = "the one before";
  CHECK_THROWS_AS(Device::open(info), NoDeviceError);
  CHECK_THROWS_WITH(Device::open(info), Contains("devices have changed"));
}

TEST_CASE("the list without a driver is empty, and the message names the packages to install") {
  const EnvironmentGuard files("VK_DRIVER_FILES", "/nonexistent.json");
  const EnvironmentGuard names("VK_ICD_FILENAMES", "/nonexistent.json");
  CHECK(listDevices().empty());
  CHECK_THROWS_AS(selectDevice(""), NoDeviceError);
  CHECK_THROWS_WITH(Device::open(), Contains("apt-get install mesa-vulkan-drivers"));
}
