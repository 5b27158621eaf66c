// Converts exceptions of Vulkan-Hpp to those of Candela.
#pragma once
#include <string>
#include <vulkan/vulkan_raii.hpp>

namespace candela::vulkan {

/// Throws DeviceLostError, OutOfMemoryError, NoDeviceError, or InternalError with the name of the result. `doing`
/// completes "cannot
/// ...".
[[noreturn]] void throwTranslated(const vk::SystemError& error, const std::string& doing);

/// Calls `f` and converts its Vulkan errors.
template <class F>
decltype(auto) guarded(const char* doing, F&& f) {
  try {
    return f();
  } catch (const vk::SystemError& error) {
    throwTranslated(error, doing);
  }
}

}  // namespace candela::vulkan
