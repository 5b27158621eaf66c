// Sessions of the device, which are prepared on separate threads.
#pragma once
#include <functional>
#include <future>
#include <vector>

#include "host/view/engine_hooks.h"

namespace candela::view {

/// One preparation that is wanted, and those that are not wanted any more but must end.
class DevicePreparation {
 public:
  /// Starts a preparation in place of the one that is under way.
  void start(const std::function<Sessions()>& prepare);
  /// Nothing is wanted any more.
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
