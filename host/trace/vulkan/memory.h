// Buffers with their own memory, which Buffer, staging and windows use.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vulkan/vulkan_raii.hpp>

#include "host/trace/vulkan/device.h"

namespace candela::vulkan {

enum class MemoryPreference {
  device,  ///< fast for the device
  host,    ///< mapped, and fast for the host to read
};

/// A buffer with its own memory. The order of the members matters: the buffer is destroyed before its memory.
struct RawBuffer {
  vk::raii::DeviceMemory memory{nullptr};
  vk::raii::Buffer handle{nullptr};
  std::uint64_t bytes = 0;
  std::byte* mapped = nullptr;    ///< null if the host cannot or should not map it
  bool isInSystemMemory = false;  ///< device memory was preferred, but had no room
};

/// Returns whether a device has memory that MemoryPreference::host suits.
bool hasHostMemory(const vk::PhysicalDeviceMemoryProperties& memory);

/// Tries the suitable memory types in the order of `preference`. Throws OutOfMemoryError.
RawBuffer allocate(const Device::Impl& device, std::uint64_t bytes, vk::BufferUsageFlags usage,
                   MemoryPreference preference);

}  // namespace candela::vulkan
