// Converts exceptions of Vulkan-Hpp to those of Candela.
#include "host/vulkan/vulkan_errors.h"

#include <fmt/format.h>

#include "host/core/errors.h"

namespace candela::vulkan {

void throwTranslated(const vk::SystemError& error, const std::string& doing) {
  const auto result = static_cast<vk::Result>(error.code().value());
  const std::string message = fmt::format("cannot {}: Vulkan says {}", doing, vk::to_string(result));
  switch (result) {
    case vk::Result::eErrorDeviceLost:
      throw DeviceLostError(message);
    case vk::Result::eErrorOutOfDeviceMemory:
    case vk::Result::eErrorOutOfHostMemory:
      throw OutOfMemoryError(message);
    default:
      throw InternalError(message);
  }
}

}  // namespace candela::vulkan
