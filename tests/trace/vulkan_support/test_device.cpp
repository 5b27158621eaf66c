// The Vulkan device that tests run on.
#include "tests/trace/vulkan_support/test_device.h"

#include <cstdlib>
#include <utility>
#include <vector>

namespace candela {
namespace {

std::vector<std::function<void()>>& actions() {
  static std::vector<std::function<void()>> list;
  return list;
}

}  // namespace

vulkan::Device openTestDevice(const vulkan::DeviceOptions& options) {
  const char* selector = std::getenv("CANDELA_TEST_DEVICE");
  return vulkan::Device::open(selector != nullptr ? selector : "", options);
}

void atTestRunEnd(std::function<void()> action) { actions().push_back(std::move(action)); }

void endTestRun() {
  for (; !actions().empty(); actions().pop_back()) actions().back()();
}

}  // namespace candela
