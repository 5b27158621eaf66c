// Compares sizes with the memory of a device.
#include "host/device/device_memory.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/core/errors.h"
#include "host/core/memory_budget.h"

namespace candela::device {

std::uint64_t usableMemory(const vulkan::DeviceInfo& info) {
  return info.type == "CPU" ? std::min(info.memoryBytes, memoryBudget()) : info.memoryBytes;
}

void requireDeviceMemory(const vulkan::DeviceInfo& info, std::uint64_t sceneBytes, std::uint64_t rowBytes) {
  const std::uint64_t usable = usableMemory(info);
  if (sceneBytes + rowBytes <= usable) return;
  throw DeviceLimitError(fmt::format(
      "the scene needs {} MiB and a row of the image {} MiB on {}, which may use {} MiB: try --layout cwbvh, "
      "a smaller --size, another --device, or --device cpu",
      sceneBytes >> 20, (rowBytes >> 20) + 1, info.name, usable >> 20));
}

}  // namespace candela::device
