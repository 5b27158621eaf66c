// Queries the properties of Vulkan devices.
#include "host/trace/vulkan/device_info.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "host/trace/vulkan/describe.h"
#include "host/trace/vulkan/device_choice.h"
#include "host/trace/vulkan/instance.h"
#include "host/trace/vulkan/memory.h"
#include "host/trace/vulkan/stand_in.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {
namespace {

std::string versionText(std::uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

const char* typeName(vk::PhysicalDeviceType type) {
  switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
      return "discrete GPU";
    case vk::PhysicalDeviceType::eIntegratedGpu:
      return "integrated GPU";
    case vk::PhysicalDeviceType::eVirtualGpu:
      return "virtual GPU";
    case vk::PhysicalDeviceType::eCpu:
      return "CPU";
    default:
      return "other";
  }
}

std::uint64_t deviceLocalBytes(const vk::raii::PhysicalDevice& device) {
  const vk::PhysicalDeviceMemoryProperties memory = device.getMemoryProperties();
  std::uint64_t bytes = 0;
  for (std::uint32_t heap = 0; heap < memory.memoryHeapCount; ++heap) {
    if (memory.memoryHeaps[heap].flags & vk::MemoryHeapFlagBits::eDeviceLocal) bytes += memory.memoryHeaps[heap].size;
  }
  return bytes;
}

/// Returns why a device with a compute queue cannot render; empty if it can.
std::string whyItRunsNothing(const vk::raii::PhysicalDevice& device, const DeviceInfo& info) {
  const std::string standIn = info.isSoftware() ? "" : standInFor(info.name, loadedLibraries());
  if (!standIn.empty())
    return fmt::format("there is no such GPU: {} stands in for it, which compiles kernels and executes nothing",
                       standIn);
  if (hasHostMemory(device.getMemoryProperties())) return "";
  return "it has no memory that the host can map, so that it only compiles kernels";
}

void fillLimits(DeviceInfo& info, const vk::PhysicalDeviceLimits& limits) {
  info.maxStorageBufferRange = limits.maxStorageBufferRange;
  info.maxTexelBufferElements = limits.maxTexelBufferElements;
  info.maxWorkgroupInvocations = limits.maxComputeWorkGroupInvocations;
  for (std::size_t axis = 0; axis < 3; ++axis) info.maxWorkgroupSize[axis] = limits.maxComputeWorkGroupSize[axis];
}

/// Queries the properties of Vulkan 1.2. There are only these three structures, because SwiftShader prints a warning
/// about any that it does not know.
void fillDriver(DeviceInfo& info, const vk::raii::PhysicalDevice& device) {
  const auto chain = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties,
                                           vk::PhysicalDeviceIDProperties, vk::PhysicalDeviceSubgroupProperties>();
  const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
  info.driverName = driver.driverName.data();
  info.driver = fmt::format("{} {}", info.driverName, driver.driverInfo.data());
  while (!info.driver.empty() && info.driver.back() == ' ') info.driver.pop_back();
  info.driverUuid = fmt::format("{:02x}", fmt::join(chain.get<vk::PhysicalDeviceIDProperties>().driverUUID, ""));
  info.subgroupSize = chain.get<vk::PhysicalDeviceSubgroupProperties>().subgroupSize;
}

void fillSubgroupSizes(DeviceInfo& info, const vk::raii::PhysicalDevice& device) {
  if (!hasExtension(device, VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME)) return;
  using Features = vk::PhysicalDeviceSubgroupSizeControlFeaturesEXT;
  using Properties = vk::PhysicalDeviceSubgroupSizeControlPropertiesEXT;
  const auto features = device.getFeatures2<vk::PhysicalDeviceFeatures2, Features>();
  const auto chain = device.getProperties2<vk::PhysicalDeviceProperties2, Properties>();
  const Properties& sizes = chain.get<Properties>();
  const bool forCompute = static_cast<bool>(sizes.requiredSubgroupSizeStages & vk::ShaderStageFlagBits::eCompute);
  if (!features.get<Features>().subgroupSizeControl || !forCompute) return;
  info.minSubgroupSize = sizes.minSubgroupSize;
  info.maxSubgroupSize = sizes.maxSubgroupSize;
}

}  // namespace

bool hasExtension(const vk::raii::PhysicalDevice& device, std::string_view name) {
  const std::vector<vk::ExtensionProperties> extensions = device.enumerateDeviceExtensionProperties();
  return std::ranges::any_of(extensions, [name](const vk::ExtensionProperties& extension) {
    return std::string_view(extension.extensionName.data()) == name;
  });
}

std::optional<std::uint32_t> findComputeQueue(const vk::raii::PhysicalDevice& device) {
  const std::vector<vk::QueueFamilyProperties> families = device.getQueueFamilyProperties();
  for (std::uint32_t family = 0; family < families.size(); ++family) {
    if (families[family].queueFlags & vk::QueueFlagBits::eCompute) return family;
  }
  return std::nullopt;
}

DeviceInfo describe(const vk::raii::PhysicalDevice& device, std::uint32_t index) {
  const vk::PhysicalDeviceProperties properties = device.getProperties();
  DeviceInfo info;
  info.index = index;
  info.name = properties.deviceName.data();
  info.type = typeName(properties.deviceType);
  info.driverVersion = properties.driverVersion;
  info.pipelineCacheUuid = fmt::format("{:02x}", fmt::join(properties.pipelineCacheUUID, ""));
  info.apiVersion = versionText(properties.apiVersion);
  info.memoryBytes = deviceLocalBytes(device);
  fillLimits(info, properties.limits);
  if (properties.apiVersion < VK_API_VERSION_1_2) {
    info.whyNot = fmt::format("it supports only Vulkan {}; 1.2 is required", info.apiVersion);
    return info;
  }
  fillDriver(info, device);
  fillSubgroupSizes(info, device);
  if (!findComputeQueue(device)) {
    info.whyNot = "it has no compute queue";
    return info;
  }
  info.compiles = true;
  info.whyNot = whyItRunsNothing(device, info);
  info.usable = info.whyNot.empty();
  return info;
}

std::vector<DeviceInfo> describeAll(const std::vector<vk::raii::PhysicalDevice>& devices) {
  return guarded("query the devices", [&] {
    std::vector<DeviceInfo> infos;
    for (const vk::raii::PhysicalDevice& device : devices) {
      infos.push_back(describe(device, static_cast<std::uint32_t>(infos.size())));
    }
    return infos;
  });
}

std::vector<DeviceInfo> listDevices() {
  const std::optional<Instance> instance = openInstance();
  if (!instance) return {};
  return describeAll(instance->physicalDevices());
}

DeviceInfo selectDevice(const std::string& selector) { return chooseDevice(listDevices(), selector); }

}  // namespace candela::vulkan
