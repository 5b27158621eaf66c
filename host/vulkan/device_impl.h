// The Vulkan handles behind a Device, and raw buffers, which staging and Buffer share.
#pragma once
#include <functional>
#include <optional>
#include <vulkan/vulkan_raii.hpp>

#include "host/vulkan/device.h"
#include "host/vulkan/instance.h"

namespace candela::vulkan {

enum class MemoryPreference {
  device,  ///< quick for the device
  host,    ///< mapped, and quick for the host to read
};

/// A buffer with memory of its own. The order of members is the order of making: the buffer goes before its memory.
struct RawBuffer {
  vk::raii::DeviceMemory memory{nullptr};
  vk::raii::Buffer handle{nullptr};
  std::uint64_t bytes = 0;
  std::byte* mapped = nullptr;  ///< null if the host cannot map it, or should not
};

struct Device::Impl {
  DeviceInfo info;
  DeviceOptions options;
  Instance instance;
  vk::raii::PhysicalDevice physicalDevice;
  vk::PhysicalDeviceLimits limits;
  vk::PhysicalDeviceMemoryProperties memoryProperties;
  vk::raii::Device handle{nullptr};
  vk::raii::Queue queue{nullptr};
  vk::raii::CommandPool commandPool{nullptr};
  vk::raii::CommandBuffer commands{nullptr};
  vk::raii::Fence fence{nullptr};
  std::optional<RawBuffer> stagingBuffer;  ///< made when first needed
  MemoryUse memoryUse;

  Impl(Instance&& openedInstance, vk::raii::PhysicalDevice&& device, const DeviceInfo& deviceInfo,
       const DeviceOptions& deviceOptions);

  /// Tries the memory types that suit in the order of `preference`. Throws OutOfMemoryError.
  RawBuffer allocate(std::uint64_t bytes, vk::BufferUsageFlags usage, MemoryPreference preference);
  RawBuffer& staging();

  /// Records, submits and waits; returns seconds. The body of Device::run.
  double run(const std::function<void(const CommandRecorder::Impl&)>& record);

 private:
  double submitAndWait();
};

}  // namespace candela::vulkan
