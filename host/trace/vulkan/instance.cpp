// Opens Vulkan instances: the loader, the API version, portability and validation.
#include "host/trace/vulkan/instance.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "host/base/errors.h"
#include "host/trace/vulkan/validation.h"
#include "host/trace/vulkan/validation_log.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr std::array kValidationFeatures{vk::ValidationFeatureEnableEXT::eSynchronizationValidation};

VKAPI_ATTR VkBool32 VKAPI_CALL collectMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                              const VkDebugUtilsMessengerCallbackDataEXT* data, void*) noexcept {
  addValidationMessage(data->pMessage != nullptr ? data->pMessage : "a message without text");
  return VK_FALSE;
}

/// Requests warnings and errors of the layer. Messages of the loader have the type "general" and are ignored. The
/// result is a C structure, because the type of the callback differs between versions of vulkan.hpp.
vk::DebugUtilsMessengerCreateInfoEXT messengerInfo() {
  VkDebugUtilsMessengerCreateInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                         VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  info.pfnUserCallback = collectMessage;
  return info;
}

bool hasExtension(const std::vector<vk::ExtensionProperties>& extensions, const char* name) {
  return std::any_of(extensions.begin(), extensions.end(),
                     [name](const auto& extension) { return std::strcmp(extension.extensionName, name) == 0; });
}

void requireValidationLayer(const vk::raii::Context& context) {
  if (hasValidationLayer(context)) return;
  throw NoDeviceError(std::string("CANDELA_VALIDATION requires the Vulkan layer ") + kValidationLayer +
                      ", which is not installed; on Debian: apt-get install vulkan-validationlayers");
}

vk::raii::Instance createInstance(const vk::raii::Context& context, bool validation,
                                  const std::vector<std::string>& windowExtensions) {
  const vk::ApplicationInfo application("candela", 0, "candela", 0, VK_API_VERSION_1_2);
  const vk::ValidationFeaturesEXT features(kValidationFeatures);
  vk::DebugUtilsMessengerCreateInfoEXT messenger = messengerInfo();
  messenger.pNext = &features;

  vk::InstanceCreateInfo info({}, &application);
  std::vector<const char*> extensions;
  for (const std::string& extension : windowExtensions) extensions.push_back(extension.c_str());
  std::vector<const char*> layers;
  if (validation) {
    layers.push_back(kValidationLayer);
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    info.pNext = &messenger;
  }
  // Without this, implementations layered on another API (MoltenVK) are hidden.
  if (hasExtension(context.enumerateInstanceExtensionProperties(), VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME)) {
    extensions.push_back(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME);
    info.flags |= vk::InstanceCreateFlagBits::eEnumeratePortabilityKHR;
  }
  info.setPEnabledLayerNames(layers).setPEnabledExtensionNames(extensions);
  return vk::raii::Instance(context, info);
}

}  // namespace

std::optional<vk::raii::Context> openLoader() {
  try {
    return std::make_optional<vk::raii::Context>();
  } catch (const std::runtime_error&) {  // no libvulkan
    return std::nullopt;
  }
}

bool hasValidationLayer(const vk::raii::Context& context) {
  const std::vector<vk::LayerProperties> layers = context.enumerateInstanceLayerProperties();
  return std::ranges::any_of(layers,
                             [](const auto& layer) { return std::strcmp(layer.layerName, kValidationLayer) == 0; });
}

std::vector<vk::raii::PhysicalDevice> Instance::physicalDevices() const {
  try {
    return handle.enumeratePhysicalDevices();
  } catch (const vk::InitializationFailedError&) {  // result of the loader if no driver has a device
    return {};
  } catch (const vk::SystemError& error) {
    throwTranslated(error, "list Vulkan devices");
  }
}

std::optional<Instance> openInstance(const std::vector<std::string>& windowExtensions) {
  std::optional<vk::raii::Context> context = openLoader();
  if (!context) return std::nullopt;
  const bool validation = validationRequested();
  try {
    if (validation) requireValidationLayer(*context);
    Instance instance{std::move(*context)};
    instance.handle = createInstance(instance.context, validation, windowExtensions);
    if (validation) instance.messenger = instance.handle.createDebugUtilsMessengerEXT(messengerInfo());
    return instance;
  } catch (const vk::IncompatibleDriverError&) {  // a loader without any driver
    return std::nullopt;
  } catch (const vk::SystemError& error) {
    throwTranslated(error, "open Vulkan");
  }
}

}  // namespace candela::vulkan
