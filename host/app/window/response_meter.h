// Measures how fast the window responds to input.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "host/base/progress.h"

namespace candela::window {

/// Measures the time from an event that moves the camera to the frame that shows the new view. Several events between
/// two frames count once, from the first of them.
class ResponseMeter {
 public:
  /// An event moved the camera at this time of monotonicSeconds().
  void moved(double time) {
    if (!movedAt_) movedAt_ = time;
  }
  bool hasMoved() const { return movedAt_.has_value(); }

  /// The engine has the new camera, and gave its view this serial number.
  void sent(std::uint64_t viewSerial) {
    waiting_.push_back({viewSerial, *movedAt_});
    movedAt_.reset();
  }
  /// A frame shows the view with this serial number.
  void shown(std::uint64_t viewSerial) {
    const double now = monotonicSeconds();
    std::erase_if(waiting_, [&](const Waiting& each) {
      if (each.viewSerial > viewSerial) return false;
      seconds_.push_back(now - each.since);
      return true;
    });
  }

  const std::vector<double>& seconds() const { return seconds_; }
  double last() const { return seconds_.empty() ? 0 : seconds_.back(); }

 private:
  struct Waiting {
    std::uint64_t viewSerial;
    double since;
  };
  std::vector<Waiting> waiting_;   ///< oldest first
  std::optional<double> movedAt_;  ///< time of the event that the engine has not received yet
  std::vector<double> seconds_;
};

}  // namespace candela::window
