// The bytes of the buffers of a device.
#pragma once
#include <algorithm>
#include <cstdint>
#include <mutex>

namespace candela::vulkan {

struct MemoryUse {
  std::uint64_t currentBytes = 0;
  std::uint64_t peakBytes = 0;
  std::uint64_t systemBytes = 0;  ///< of currentBytes, those for which device memory had no room
};

/// Counts buffers as they are created and destroyed, by any thread.
class MemoryTally {
 public:
  void add(std::uint64_t bytes, bool isInSystemMemory) {
    const std::scoped_lock lock(mutex_);
    use_.currentBytes += bytes;
    use_.peakBytes = std::max(use_.peakBytes, use_.currentBytes);
    if (isInSystemMemory) use_.systemBytes += bytes;
  }
  /// The arguments are those of an earlier call of add().
  void remove(std::uint64_t bytes, bool isInSystemMemory) {
    const std::scoped_lock lock(mutex_);
    use_.currentBytes -= bytes;
    if (isInSystemMemory) use_.systemBytes -= bytes;
  }
  MemoryUse use() const {
    const std::scoped_lock lock(mutex_);
    return use_;
  }

 private:
  mutable std::mutex mutex_;
  MemoryUse use_;
};

}  // namespace candela::vulkan
