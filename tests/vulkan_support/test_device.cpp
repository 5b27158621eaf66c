// The Vulkan device that tests run on.
#include "tests/vulkan_support/test_device.h"

#include <cstdlib>

namespace candela {

vulkan::Device openTestDevice(const vulkan::DeviceOptions& options) {
  const char* selector = std::getenv("CANDELA_TEST_DEVICE");
  return vulkan::Device::open(selector != nullptr ? selector : "", options);
}

}  // namespace candela
