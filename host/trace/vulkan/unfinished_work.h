// Reports whether work that was submitted to a device may still be running. This header uses no Vulkan type.
#pragma once

namespace candela::vulkan {

/// Returns whether this process gave up waiting for a device. Threads of the driver may then still be at work, so that
/// the process must end without running the destructors of libraries: std::_Exit(). Thread-safe.
bool hasUnfinishedWork();

}  // namespace candela::vulkan
