// Chooses memory for buffers: the memory types of a device and their order.
#include "host/trace/vulkan/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "host/base/errors.h"
#include "host/trace/vulkan/device_impl.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {
namespace {

using Flag = vk::MemoryPropertyFlagBits;

bool contains(vk::MemoryPropertyFlags set, vk::MemoryPropertyFlags flags) { return (set & flags) == flags; }

/// Memory that host and device access at full speed. Device memory that the host maps without a cache (that of a
/// discrete GPU across the bus) is a hundred times slower to read than a copy through staging.
bool isUnified(vk::MemoryPropertyFlags flags) {
  return contains(flags, Flag::eDeviceLocal | Flag::eHostVisible | Flag::eHostCoherent | Flag::eHostCached);
}

/// Properties of memory that must not be allocated without further features or handles, or that caches bypass.
constexpr vk::MemoryPropertyFlags kUnusable = Flag::eLazilyAllocated | Flag::eProtected | Flag::eDeviceCoherentAMD |
                                              Flag::eDeviceUncachedAMD | Flag::eRdmaCapableNV;

/// Rates the suitability of a memory type; higher is better, 0 is unsuitable. `isFirst`: it is the first type of device
/// memory. A driver lists types in the order of their speed, so that unified memory after it is slower for the device
/// (RADV on integrated GPUs: snooped system memory).
int score(vk::MemoryPropertyFlags flags, bool isFirst, MemoryPreference preference) {
  const bool isMappable = contains(flags, Flag::eHostVisible | Flag::eHostCoherent);
  if (flags & kUnusable) return 0;
  if (preference == MemoryPreference::host) {
    if (!isMappable) return 0;
    return (flags & Flag::eHostCached) ? 2 : 1;
  }
  if (isUnified(flags) && isFirst) return 4;
  if (flags & Flag::eDeviceLocal) return isMappable ? 2 : 3;
  return 1;
}

/// Returns the indices of the suitable memory types among `allowedTypes` (a bit mask), best first.
std::vector<std::uint32_t> suitableTypes(const vk::PhysicalDeviceMemoryProperties& memory, std::uint32_t allowedTypes,
                                         MemoryPreference preference) {
  std::vector<std::uint32_t> types;
  const auto flagsOf = [&](std::uint32_t type) { return memory.memoryTypes[type].propertyFlags; };
  std::uint32_t first = 0;
  while (first < memory.memoryTypeCount && !(flagsOf(first) & Flag::eDeviceLocal)) ++first;
  const auto scoreOf = [&](std::uint32_t type) { return score(flagsOf(type), type == first, preference); };
  for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
    if ((allowedTypes >> type & 1u) != 0 && scoreOf(type) > 0) types.push_back(type);
  }
  std::stable_sort(types.begin(), types.end(), [&](auto a, auto b) { return scoreOf(a) > scoreOf(b); });
  return types;
}

/// Returns null if the heap of the type has no room.
vk::raii::DeviceMemory tryAllocate(const Device::Impl& device, std::uint64_t bytes, std::uint32_t type) {
  const vk::MemoryHeap& heap = device.memoryProperties.memoryHeaps[device.memoryProperties.memoryTypes[type].heapIndex];
  if (bytes > heap.size) return nullptr;
  try {
    return device.handle.allocateMemory({bytes, type});
  } catch (const vk::OutOfDeviceMemoryError&) {
    return nullptr;
  }
}

}  // namespace

bool hasHostMemory(const vk::PhysicalDeviceMemoryProperties& memory) {
  return !suitableTypes(memory, ~std::uint32_t{0}, MemoryPreference::host).empty();
}

RawBuffer allocate(const Device::Impl& device, std::uint64_t bytes, vk::BufferUsageFlags usage,
                   MemoryPreference preference) {
  const vk::PhysicalDeviceMemoryProperties& memory = device.memoryProperties;
  const std::string doing = fmt::format("create a buffer of {} bytes on {}", bytes, device.info.name);
  try {
    RawBuffer buffer;
    buffer.bytes = bytes;
    buffer.handle = device.handle.createBuffer({{}, bytes, usage, vk::SharingMode::eExclusive});
    const vk::MemoryRequirements needs = buffer.handle.getMemoryRequirements();
    for (const std::uint32_t type : suitableTypes(memory, needs.memoryTypeBits, preference)) {
      buffer.memory = tryAllocate(device, needs.size, type);
      if (!*buffer.memory) continue;
      buffer.handle.bindMemory(*buffer.memory, 0);
      const bool map = preference == MemoryPreference::host ||
                       (device.options.mapDeviceMemory && isUnified(memory.memoryTypes[type].propertyFlags));
      const bool isOnDevice = bool(memory.memoryTypes[type].propertyFlags & Flag::eDeviceLocal);
      buffer.isInSystemMemory = preference == MemoryPreference::device && !isOnDevice;
      if (map) buffer.mapped = static_cast<std::byte*>(buffer.memory.mapMemory(0, VK_WHOLE_SIZE));
      return buffer;
    }
  } catch (const vk::SystemError& error) {
    throwTranslated(error, doing);
  }
  throw OutOfMemoryError(fmt::format("cannot {}, whose buffers already occupy {} of its {} bytes", doing,
                                     device.memory.use().currentBytes, device.info.memoryBytes));
}

}  // namespace candela::vulkan
