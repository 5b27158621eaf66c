// Lists Vulkan devices in a child process, since a driver may crash while it enumerates them.
#pragma once
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/drivers/doctor/check.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::vulkan {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DeviceInfo, index, name, type, driverName, driver, driverVersion, pipelineCacheUuid,
                                   apiVersion, usable, whyNot, compiles, memoryBytes, maxStorageBufferRange,
                                   maxTexelBufferElements, maxWorkgroupInvocations, maxWorkgroupSize, subgroupSize,
                                   minSubgroupSize, maxSubgroupSize)
}  // namespace candela::vulkan

namespace candela::doctor {

/// Time after which a driver that still enumerates devices counts as hung.
inline constexpr std::chrono::seconds kListLimit{30};

struct ListedDevices {
  std::vector<vulkan::DeviceInfo> devices;
  std::string failure;  ///< as ChildResult::failure
};

/// Lists the devices of all drivers, or only of the driver of `manifest`, after opening `library` to learn why that
/// fails. Validation is off.
ListedDevices listAllDevices();
ListedDevices listDevicesOf(const std::string& manifest, const std::string& library);

/// Two lines for each device: its description, and the limits that matter.
Checks checkDevices(const std::vector<vulkan::DeviceInfo>& devices);

}  // namespace candela::doctor
