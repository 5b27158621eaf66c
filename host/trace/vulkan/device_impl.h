// The Vulkan handles of a Device, and the work that it submits.
#pragma once
#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <vulkan/vulkan_raii.hpp>

#include "host/trace/vulkan/device.h"
#include "host/trace/vulkan/hang_limit.h"
#include "host/trace/vulkan/instance.h"
#include "host/trace/vulkan/memory.h"
#include "host/trace/vulkan/memory_tally.h"
#include "host/trace/vulkan/recording.h"
#include "host/trace/vulkan/residents.h"

namespace candela::vulkan {

struct Device::Impl : std::enable_shared_from_this<Device::Impl> {
  DeviceInfo info;
  DeviceOptions options;
  Instance instance;
  vk::raii::PhysicalDevice physicalDevice;
  vk::PhysicalDeviceLimits limits;
  vk::PhysicalDeviceMemoryProperties memoryProperties;
  vk::raii::Device handle{nullptr};
  std::uint32_t queueFamily = 0;
  vk::raii::Queue queue{nullptr};
  std::mutex queueMutex;  ///< held whenever the queue is used
  /// A second queue of the family for vkQueuePresentKHR, which may block; null if there is only one, or no window. Only
  /// the window's thread uses it.
  vk::raii::Queue presentQueue{nullptr};
  bool canPresent = false;
  bool reportsExecutables = false;  ///< VK_KHR_pipeline_executable_properties is enabled
  vk::raii::PipelineCache pipelineCache{nullptr};
  vk::raii::CommandPool commandPool{nullptr};
  vk::raii::CommandBuffer commands{nullptr};
  vk::raii::Fence fence{nullptr};
  std::optional<RawBuffer> stagingBuffer;  ///< created when it is first needed
  MemoryTally memory;                      ///< of all Buffer objects
  Residents residents;                     ///< buffers, pipelines and bindings of this device
  HangLimit hangLimit;
  std::atomic<bool> hasFailed = false;  ///< submitted work has not been confirmed to have ended normally

  Impl(Instance&& openedInstance, vk::raii::PhysicalDevice&& device, const DeviceInfo& deviceInfo,
       const DeviceOptions& deviceOptions);

  RawBuffer& staging();

  /// Adds a command to the recording, if there is one. `make` returns the command.
  template <class Make>
  void note(Make&& make) const {
    if (options.recording != nullptr) options.recording->commands.emplace_back(make());
  }

  /// Implements Device::run: records, submits and waits. Returns seconds.
  double run(const std::function<void(const CommandRecorder::Impl&)>& record);

 private:
  void makeCommands();
  double submitAndWait(FirstRun first);
  void waitForFence(FirstRun first);
  void settle();
  void keepEverything();
};

}  // namespace candela::vulkan
