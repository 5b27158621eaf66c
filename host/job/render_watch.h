// Stops a render where it is to be interrupted or its film is to be written.
#pragma once
#include <atomic>
#include <limits>
#include <mutex>
#include <thread>

#include "host/base/progress.h"

namespace candela::job {

/// A thread looks at flags and the clock, so that renders need only poll a flag.
class RenderWatch {
 public:
  /// `deadline` is a time of monotonicSeconds(), or infinity. `interrupted` ends the render while it is true;
  /// `writeRequested` has the film written and is reset. Both may be null, and must outlive the object.
  RenderWatch(double deadline, const std::atomic<bool>* interrupted, std::atomic<bool>* writeRequested);

  /// Becomes true when there is something to do.
  const std::atomic<bool>& stop() const { return stop_; }
  /// Returns whether the render has to end before it is finished.
  bool mustEnd() const { return isInterrupted() || isTimeUp(); }
  bool isTimeUp() const { return monotonicSeconds() >= deadline_; }
  /// Lets the render continue. A request to write from this call on counts as new.
  void resume();
  /// The film is to be written at `time`, of monotonicSeconds().
  void writeAt(double time);
  /// The film is to be shown at `time`, of monotonicSeconds().
  void showAt(double time);
  /// Returns whether the film has to be written, by request or because its time has come.
  bool mustWrite() const;

 private:
  bool isInterrupted() const { return interrupted_ != nullptr && interrupted_->load(std::memory_order_relaxed); }
  void run(const std::stop_token& ended);
  void look();
  bool isWriteDue() const;

  const std::atomic<bool>* interrupted_;
  std::atomic<bool>* writeRequested_;
  double deadline_;
  mutable std::mutex mutex_;  ///< of what follows, so that no look at the clock is older than resume()
  double nextWrite_ = std::numeric_limits<double>::infinity();
  double nextShow_ = std::numeric_limits<double>::infinity();
  std::atomic<bool> stop_{false};
  std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace candela::job
