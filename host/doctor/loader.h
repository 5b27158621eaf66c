// Examines the Vulkan loader and the validation layer.
#pragma once
#include "host/doctor/check.h"

namespace candela::doctor {

Checks checkLoader();

}  // namespace candela::doctor
