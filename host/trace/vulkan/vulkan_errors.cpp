// Converts exceptions of Vulkan-Hpp to those of Candela.
#include "host/trace/vulkan/vulkan_errors.h"

#include <fmt/format.h>

#include "host/base/errors.h"

namespace candela::vulkan {

void throwTranslated(const vk::SystemError& error, const std::string& doing) {
  const auto result = static_cast<vk::Result>(error.code().value());
  const std::string message = fmt::format("cannot {}: Vulkan returned {}", doing, vk::to_string(result));
  switch (result) {
    case vk::Result::eErrorDeviceLost:
    case vk::Result::eErrorUnknown:
      throw DeviceLostError(message);
    case vk::Result::eErrorOutOfDeviceMemory:
    case vk::Result::eErrorOutOfHostMemory:
    case vk::Result::eErrorOutOfPoolMemory:
    case vk::Result::eErrorFragmentedPool:
    case vk::Result::eErrorFragmentation:
    case vk::Result::eErrorMemoryMapFailed:
    case vk::Result::eErrorTooManyObjects:
      throw OutOfMemoryError(message);
    case vk::Result::eErrorInitializationFailed:
    case vk::Result::eErrorIncompatibleDriver:
    case vk::Result::eErrorLayerNotPresent:
    case vk::Result::eErrorExtensionNotPresent:
    case vk::Result::eErrorFeatureNotPresent:
      throw NoDeviceError(message + "; candela doctor checks the installation");
    default:
      throw InternalError(message);
  }
}

}  // namespace candela::vulkan
