// The messages of the Khronos validation layer, collected for the whole process.
#pragma once
#include <string>
#include <vector>

namespace candela::vulkan {

/// Whether the environment asks for validation: CANDELA_VALIDATION is set, not empty and not "0". Instances then load
/// VK_LAYER_KHRONOS_validation with synchronisation validation, or throw NoDeviceError if it is not installed.
bool validationRequested();

/// Every warning and error that the layer has given since the start or the last clear, oldest first. Any is a
/// programming error. Thread-safe.
std::vector<std::string> validationMessages();
void clearValidationMessages();

}  // namespace candela::vulkan
