// The messages of the Khronos validation layer, collected for the whole process.
#pragma once
#include <string>
#include <vector>

namespace candela::vulkan {

/// Returns whether the environment requests validation: CANDELA_VALIDATION is set, not empty and not "0". Instances
/// then load VK_LAYER_KHRONOS_validation with synchronisation validation, or throw NoDeviceError if it is not
/// installed.
bool validationRequested();

/// Returns every warning and error of the layer since the start or the last clear, oldest first. Each is a programming
/// error. Thread-safe.
std::vector<std::string> validationMessages();
void clearValidationMessages();

}  // namespace candela::vulkan
