// Selects one of several devices.
#pragma once
#include <span>
#include <string>

#include "host/trace/vulkan/device_info.h"

namespace candela::vulkan {

/// Returns the device that is used if none is selected: a usable one, of the first of these types that there is:
/// discrete GPU, integrated GPU, virtual GPU, CPU. Null if no device is usable.
const DeviceInfo* bestDevice(std::span<const DeviceInfo> devices);

/// Makes devices usable that only compile, for DeviceOptions::compilesOnly.
void allowCompilers(std::span<DeviceInfo> devices);

/// Applies the rule of selectDevice() to a list. Throws NoDeviceError.
const DeviceInfo& chooseDevice(std::span<const DeviceInfo> devices, const std::string& selector);

/// Returns one indented line per device, with the reason if it is not usable.
std::string describeDevices(std::span<const DeviceInfo> devices);

}  // namespace candela::vulkan
