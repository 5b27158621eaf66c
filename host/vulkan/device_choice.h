// Which of several devices a selector means.
#pragma once
#include <span>
#include <string>

#include "host/vulkan/device_info.h"

namespace candela::vulkan {

/// The rule of selectDevice() on a given list. Throws NoDeviceError.
const DeviceInfo& chooseDevice(std::span<const DeviceInfo> devices, const std::string& selector);

/// One line for each device, indented, with the reason if it is not usable.
std::string describeDevices(std::span<const DeviceInfo> devices);

}  // namespace candela::vulkan
