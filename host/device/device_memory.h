// The memory of a device, and the refusal of scenes that exceed it before anything is allocated.
#pragma once
#include <cstdint>

#include "host/vulkan/device_info.h"

namespace candela::device {

/// Returns the bytes that buffers may occupy: those of the device, on devices in software at most the memory budget.
std::uint64_t usableMemory(const vulkan::DeviceInfo& info);

/// Throws DeviceLimitError if the records of a scene and the buffers of one row of the image exceed that.
void requireDeviceMemory(const vulkan::DeviceInfo& info, std::uint64_t sceneBytes, std::uint64_t rowBytes);

}  // namespace candela::device
