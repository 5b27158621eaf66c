// Creates the handles of a device, and runs recorded commands.
#include "host/trace/vulkan/device_impl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/trace/vulkan/command_recorder_impl.h"
#include "host/trace/vulkan/compute_pipeline_impl.h"
#include "host/trace/vulkan/describe.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {
namespace {

// A device that implements a subset of Vulkan reports this extension, which must then be enabled. Its name is only in a
// beta header.
constexpr const char* kPortabilitySubset = "VK_KHR_portability_subset";

// Returns whether the queue supports graphics, too, and the device has swapchains.
bool presents(const vk::raii::PhysicalDevice& physicalDevice, std::uint32_t queueFamily, const DeviceOptions& options) {
  if (options.windowExtensions.empty()) return false;
  const vk::QueueFlags flags = physicalDevice.getQueueFamilyProperties()[queueFamily].queueFlags;
  return (flags & vk::QueueFlagBits::eGraphics) && hasExtension(physicalDevice, VK_KHR_SWAPCHAIN_EXTENSION_NAME);
}

// One queue renders and draws; a second one presents, if the family has it.
std::uint32_t presentingQueues(const vk::raii::PhysicalDevice& physicalDevice, std::uint32_t queueFamily) {
  return std::min(2u, physicalDevice.getQueueFamilyProperties()[queueFamily].queueCount);
}

bool hasExecutableInfo(const vk::raii::PhysicalDevice& physicalDevice) {
  if (!hasExtension(physicalDevice, VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME)) return false;
  using Features = vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR;
  return static_cast<bool>(
      physicalDevice.getFeatures2<vk::PhysicalDeviceFeatures2, Features>().get<Features>().pipelineExecutableInfo);
}

vk::raii::Device createDevice(const vk::raii::PhysicalDevice& physicalDevice, std::uint32_t queueFamily,
                              const DeviceOptions& options, bool presents, bool reportsExecutables) {
  const std::array<float, 2> priorities{1.0f, 1.0f};
  const vk::DeviceQueueCreateInfo queue({}, queueFamily, presents ? presentingQueues(physicalDevice, queueFamily) : 1,
                                        priorities.data());
  std::vector<const char*> extensions;
  if (hasExtension(physicalDevice, kPortabilitySubset)) extensions.push_back(kPortabilitySubset);
  if (presents) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  vk::PhysicalDeviceFeatures features;
  features.robustBufferAccess = options.robustBufferAccess;
  vk::PhysicalDeviceSubgroupSizeControlFeaturesEXT sizeControl(VK_TRUE);
  vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR executableInfo(VK_TRUE);
  void* chain = nullptr;
  if (options.subgroupSize > 0) {
    extensions.push_back(VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME);
    chain = &sizeControl;
  }
  if (reportsExecutables) {
    extensions.push_back(VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
    executableInfo.setPNext(chain);
    chain = &executableInfo;
  }
  return {physicalDevice, vk::DeviceCreateInfo({}, queue, {}, extensions, &features, chain)};
}

}  // namespace

Device::Impl::Impl(Instance&& openedInstance, vk::raii::PhysicalDevice&& device, const DeviceInfo& deviceInfo,
                   const DeviceOptions& deviceOptions)
    : info(deviceInfo),
      options(deviceOptions),
      instance(std::move(openedInstance)),
      physicalDevice(std::move(device)),
      limits(physicalDevice.getProperties().limits),
      memoryProperties(physicalDevice.getMemoryProperties()) {
  queueFamily = findComputeQueue(physicalDevice).value();
  canPresent = presents(physicalDevice, queueFamily, options);
  reportsExecutables = options.compilesOnly && hasExecutableInfo(physicalDevice);
  handle = createDevice(physicalDevice, queueFamily, options, canPresent, reportsExecutables);
  queue = handle.getQueue(queueFamily, 0);
  if (canPresent && presentingQueues(physicalDevice, queueFamily) > 1) presentQueue = handle.getQueue(queueFamily, 1);
  pipelineCache = handle.createPipelineCache({});
  if (!options.compilesOnly) makeCommands();
  if (options.recording == nullptr) return;
  options.recording->robustBufferAccess = options.robustBufferAccess;
  options.recording->subgroupSize = options.subgroupSize;
}

void Device::Impl::makeCommands() {
  commandPool = handle.createCommandPool({vk::CommandPoolCreateFlagBits::eTransient, queueFamily});
  const vk::CommandBufferAllocateInfo commandInfo(*commandPool, vk::CommandBufferLevel::ePrimary, 1);
  commands = std::move(handle.allocateCommandBuffers(commandInfo).front());
  fence = handle.createFence({});
  hangLimit = HangLimit(options.hangTimeout, info.isSoftware());
}

RawBuffer& Device::Impl::staging() {
  if (!stagingBuffer) {
    const auto usage = vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst;
    stagingBuffer = allocate(*this, options.stagingBytes, usage, MemoryPreference::host);
  }
  return *stagingBuffer;
}

double Device::Impl::run(const std::function<void(const CommandRecorder::Impl&)>& record) {
  if (hasFailed) throw DeviceLostError(fmt::format("{} cannot be used any more, since work on it failed", info.name));
  guarded("start recording commands", [&] {
    commandPool.reset();
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
  });
  const CommandRecorder::Impl recorder{*this, commands};
  record(recorder);
  recorder.makeVisibleToHost();
  const double seconds = guarded("run commands on the device", [&] {
    commands.end();
    return submitAndWait(recorder.newPipelines.empty() ? FirstRun::none : FirstRun::ofPipeline);
  });
  for (const auto& pipeline : recorder.newPipelines) pipeline->hasRun = true;
  return seconds;
}

// Objects that the device may be using are never destroyed: this object and those that refer to it.
void Device::Impl::keepEverything() {
  residents.add(shared_from_this());
  residents.keepAll();
}

// After a failed submission or wait, the commands may be running. VK_ERROR_DEVICE_LOST is then equivalent to success:
// according to the specification, a lost device uses no resources.
void Device::Impl::settle() {
  hasFailed = true;
  const std::scoped_lock lock(queueMutex);
  try {
    handle.waitIdle();
  } catch (const vk::DeviceLostError&) {
  } catch (const vk::SystemError&) {
    keepEverything();
  }
}

void Device::Impl::waitForFence(FirstRun first) {
  const vk::Result result = handle.waitForFences(*fence, VK_TRUE, hangLimit.nanoseconds(first));
  if (result == vk::Result::eSuccess) return;
  hasFailed = true;
  keepEverything();
  throw DeviceHungError(fmt::format("{} has not finished its work after {:.0f} s; {} sets this limit", info.name,
                                    hangLimit.seconds(first), settingWords("hang-timeout")));
}

double Device::Impl::submitAndWait(FirstRun first) {
  handle.resetFences(*fence);
  const vk::SubmitInfo submission({}, {}, *commands);
  const auto start = std::chrono::steady_clock::now();
  try {
    {
      const std::scoped_lock lock(queueMutex);
      queue.submit(submission, *fence);
    }
    waitForFence(first);
  } catch (const vk::SystemError&) {
    settle();
    throw;
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  hangLimit.record(first, elapsed.count());
  return elapsed.count();
}

}  // namespace candela::vulkan
