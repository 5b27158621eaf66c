// Turns Vulkan-Hpp's exceptions into Candela's.
#pragma once
#include <string>
#include <vulkan/vulkan_raii.hpp>

namespace candela::vulkan {

/// DeviceLostError, OutOfMemoryError, or InternalError with the result's name. `doing` completes "cannot ...".
[[noreturn]] void throwTranslated(const vk::SystemError& error, const std::string& doing);

/// Calls `f`, whose Vulkan errors leave as Candela's.
template <class F>
decltype(auto) guarded(const char* doing, F&& f) {
  try {
    return f();
  } catch (const vk::SystemError& error) {
    throwTranslated(error, doing);
  }
}

}  // namespace candela::vulkan
