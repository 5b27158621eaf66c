// A Vulkan instance, with the validation layer if the environment requests it.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

namespace candela::vulkan {

struct Instance {
  vk::raii::Context context;
  vk::raii::Instance handle{nullptr};
  vk::raii::DebugUtilsMessengerEXT messenger{nullptr};  ///< null without validation

  /// In the order of the loader; empty if no driver has a device.
  std::vector<vk::raii::PhysicalDevice> physicalDevices() const;
};

/// Returns nothing if there is no Vulkan loader. Opens no driver.
std::optional<vk::raii::Context> openLoader();

/// Returns whether the Khronos validation layer is installed.
bool hasValidationLayer(const vk::raii::Context& context);

/// Returns nothing if there is no Vulkan loader or no driver. Enables `windowExtensions`, which the loader must have.
/// Throws NoDeviceError if validation is requested but not installed.
std::optional<Instance> openInstance(const std::vector<std::string>& windowExtensions = {});

}  // namespace candela::vulkan
