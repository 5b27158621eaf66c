// The device that a selector selects, from handwritten lists.
#include "host/trace/vulkan/device_choice.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/trace/vulkan/environment_guard.h"

using namespace candela;
using namespace candela::vulkan;
using Catch::Matchers::Contains;
using Catch::Matchers::Message;
using vulkan::chooseDevice;

namespace {

DeviceInfo makeInfo(std::uint32_t index, const char* name, const char* type, const char* whyNot = "") {
  DeviceInfo info;
  info.index = index;
  info.name = name;
  info.type = type;
  info.whyNot = whyNot;
  info.usable = info.whyNot.empty();
  return info;
}

const std::vector<DeviceInfo> kDevices{
    makeInfo(0, "llvmpipe (LLVM 15.0.6, 256 bits)", "CPU"),
    makeInfo(1, "Old GeForce 640", "discrete GPU", "it supports only Vulkan 1.1.2; 1.2 is required"),
    makeInfo(2, "Iris Graphics", "integrated GPU"),
    makeInfo(3, "GeForce RTX 3060", "discrete GPU"),
};

std::string messageOf(std::span<const DeviceInfo> devices, const std::string& selector) {
  try {
    chooseDevice(devices, selector);
  } catch (const NoDeviceError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("the choice without a selector depends on the type: discrete, integrated, virtual, CPU, other") {
  const std::vector<DeviceInfo> others{makeInfo(0, "a", "other"), makeInfo(1, "b", "CPU"),
                                       makeInfo(2, "c", "virtual GPU")};
  CHECK(chooseDevice(kDevices, "").index == 3);
  CHECK(chooseDevice(std::span(kDevices).first(3), "").index == 2);
  CHECK(chooseDevice(std::span(kDevices).first(2), "").index == 0);
  CHECK(chooseDevice(others, "").index == 2);
  CHECK(chooseDevice(std::span(others).first(2), "").index == 1);
}

TEST_CASE("the first of several devices of one type is chosen") {
  const std::vector<DeviceInfo> twins{makeInfo(0, "a", "discrete GPU"), makeInfo(1, "b", "discrete GPU")};
  CHECK(chooseDevice(twins, "").index == 0);
}

TEST_CASE("a selector is an index or a part of a name in any case") {
  CHECK(chooseDevice(kDevices, "2").index == 2);
  CHECK(chooseDevice(kDevices, "LLVMPIPE").index == 0);
  CHECK(chooseDevice(kDevices, "iris").index == 2);
}

TEST_CASE("a selector with a number beyond the list is a part of a name") {
  CHECK(chooseDevice(kDevices, "3060").index == 3);
}

TEST_CASE("a usable device is preferred among several with the name") {
  CHECK(chooseDevice(kDevices, "geforce").index == 3);
}

TEST_CASE("selecting an unusable device names the reason") {
  CHECK_THAT(messageOf(kDevices, "1"),
             Contains("1 (Old GeForce 640) is not usable: it supports only Vulkan 1.1.2; 1.2 is required"));
  CHECK_THAT(messageOf(kDevices, "640"), Contains("not usable"));
}

TEST_CASE("the message without a device names the variable that selects drivers, and what else renders") {
  const EnvironmentGuard older("VK_ICD_FILENAMES", "/other.json");
  {
    const EnvironmentGuard driver("VK_DRIVER_FILES", "/nosuch.json");
    CHECK_THAT(messageOf({}, ""), Contains("VK_DRIVER_FILES allows only the driver /nosuch.json"));
  }
  const EnvironmentGuard none("VK_DRIVER_FILES", "");
  CHECK_THAT(messageOf({}, ""), Contains("VK_ICD_FILENAMES allows only the driver /other.json"));
  CHECK_THAT(messageOf({}, ""), Contains("candela doctor") && Contains("device = cpu renders"));
  const EnvironmentGuard noneAtAll("VK_ICD_FILENAMES", "");
  CHECK_THAT(messageOf({}, ""), !Contains("environment variable"));
}

TEST_CASE("an unknown device is refused with the list of devices") {
  const std::string message = messageOf(kDevices, "radeon");
  CHECK_THAT(message, Contains("no Vulkan device \"radeon\""));
  CHECK_THAT(message, Contains("\n  0: llvmpipe (LLVM 15.0.6, 256 bits) (CPU)\n"));
  CHECK_THAT(message, Contains("\n  3: GeForce RTX 3060 (discrete GPU)"));
  CHECK_THAT(message, Contains("\n  cpu: the reference tracer"));
}

TEST_CASE("the message without a usable device names the packages to install") {
  CHECK_THAT(messageOf({}, ""), Contains("apt-get install mesa-vulkan-drivers"));
  CHECK_THAT(messageOf({}, "llvmpipe"), Contains("apt-get install mesa-vulkan-drivers"));
  CHECK_THAT(messageOf(std::span(kDevices).subspan(1, 1), ""), Contains("apt-get install mesa-vulkan-drivers"));
}
