// Converts properties of Vulkan physical devices to DeviceInfo.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "host/trace/vulkan/device_info.h"

namespace candela::vulkan {

/// Returns whether the device has this extension.
bool hasExtension(const vk::raii::PhysicalDevice& device, std::string_view name);

/// Returns the index of the first queue family that supports compute.
std::optional<std::uint32_t> findComputeQueue(const vk::raii::PhysicalDevice& device);

DeviceInfo describe(const vk::raii::PhysicalDevice& device, std::uint32_t index);
std::vector<DeviceInfo> describeAll(const std::vector<vk::raii::PhysicalDevice>& devices);

}  // namespace candela::vulkan
