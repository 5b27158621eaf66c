// Examines the Vulkan loader and the validation layer.
#pragma once
#include "host/drivers/doctor/check.h"

namespace candela::doctor {

/// The first check is that of the loader, and it is `ok` if the loader can be opened.
Checks checkLoader();

}  // namespace candela::doctor
