// Write access to the validation log.
#pragma once
#include <string>

namespace candela::vulkan {

/// Adds a message to the result of validationMessages(). Thread-safe.
void addValidationMessage(const std::string& message);

}  // namespace candela::vulkan
