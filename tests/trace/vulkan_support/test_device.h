// The Vulkan device that tests run on.
#pragma once
#include <functional>

#include "host/trace/vulkan/device.h"

namespace candela {

/// The device that CANDELA_TEST_DEVICE selects, by default the best one.
vulkan::Device openTestDevice(const vulkan::DeviceOptions& options = {});

/// Calls `action` when all test cases have run, but before exit(). Owners of Vulkan objects are destroyed in this way:
/// during exit(), the validation layer may have destroyed its own state already.
void atTestRunEnd(std::function<void()> action);
/// Calls those actions, the last one first.
void endTestRun();

}  // namespace candela
