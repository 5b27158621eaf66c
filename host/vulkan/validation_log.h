// The writing side of the validation log.
#pragma once
#include <string>

namespace candela::vulkan {

/// Adds one message to what validationMessages() gives. Thread-safe.
void addValidationMessage(const std::string& message);

}  // namespace candela::vulkan
