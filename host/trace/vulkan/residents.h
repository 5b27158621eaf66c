// The objects that a device may be using, for the case that its work cannot be waited for.
#pragma once
#include <memory>
#include <mutex>
#include <vector>

namespace candela::vulkan {

/// Objects of one device, added by any thread. Freeing one while a kernel runs on it is undefined behaviour and has
/// been seen to crash drivers. If the end of the work is unknown, keepAll() therefore keeps them until the end of the
/// process.
class Residents {
 public:
  void add(const std::shared_ptr<void>& object);
  /// Keeps every object that still exists. They are reachable, but nothing frees them any more. hasUnfinishedWork() is
  /// true from then on.
  void keepAll();

 private:
  std::mutex mutex_;
  std::vector<std::weak_ptr<void>> objects_;
};

}  // namespace candela::vulkan
