// Sessions of the device, which are prepared on separate threads.
#pragma once
#include <functional>
#include <future>
#include <vector>

#include "host/app/view/engine_hooks.h"

namespace candela::view {

/// The current preparation, and abandoned ones that must still end.
class DevicePreparation {
 public:
  /// Starts a preparation, and abandons the current one.
  void start(const std::function<Sessions()>& prepare);
  /// Abandons the current preparation.
  void abandon();
  bool isUnderWay() const { return wanted_.valid(); }
  bool isReady() const;
  /// Returns the session that is ready, or throws the exception of the preparation.
  Sessions take() { return wanted_.get(); }

 private:
  std::future<Sessions> wanted_;
  std::vector<std::future<Sessions>> abandoned_;
};

}  // namespace candela::view
