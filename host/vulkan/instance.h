// A Vulkan instance, with the validation layer if the environment asks for it.
#pragma once
#include <optional>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

namespace candela::vulkan {

struct Instance {
  vk::raii::Context context;
  vk::raii::Instance handle{nullptr};
  vk::raii::DebugUtilsMessengerEXT messenger{nullptr};  ///< null without validation

  /// In the loader's order; empty if no driver has a device.
  std::vector<vk::raii::PhysicalDevice> physicalDevices() const;
};

/// Nothing if there is no Vulkan loader or no driver. Throws NoDeviceError if validation is asked for and not
/// installed.
std::optional<Instance> openInstance();

}  // namespace candela::vulkan
