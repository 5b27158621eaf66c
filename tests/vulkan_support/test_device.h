// The Vulkan device that tests run on.
#pragma once
#include "host/vulkan/device.h"

namespace candela {

/// The device that CANDELA_TEST_DEVICE selects, by default the best one.
vulkan::Device openTestDevice(const vulkan::DeviceOptions& options = {});

}  // namespace candela
