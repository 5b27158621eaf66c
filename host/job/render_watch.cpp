// Polls every few milliseconds, which costs nothing that can be measured.
#include "host/job/render_watch.h"

#include <chrono>

namespace candela::job {

RenderWatch::RenderWatch(double deadline, const std::atomic<bool>* interrupted, std::atomic<bool>* writeRequested)
    : interrupted_(interrupted),
      writeRequested_(writeRequested),
      deadline_(deadline),
      thread_([this](const std::stop_token& ended) { run(ended); }) {}

void RenderWatch::resume() {
  const std::scoped_lock lock(mutex_);
  nextWrite_ = nextShow_ = std::numeric_limits<double>::infinity();
  if (writeRequested_ != nullptr) writeRequested_->store(false);
  stop_.store(false);
}

void RenderWatch::writeAt(double time) {
  const std::scoped_lock lock(mutex_);
  nextWrite_ = time;
}

void RenderWatch::showAt(double time) {
  const std::scoped_lock lock(mutex_);
  nextShow_ = time;
}

bool RenderWatch::isWriteDue() const {
  return (writeRequested_ != nullptr && writeRequested_->load()) || monotonicSeconds() >= nextWrite_;
}

bool RenderWatch::mustWrite() const {
  const std::scoped_lock lock(mutex_);
  return isWriteDue();
}

void RenderWatch::look() {
  const std::scoped_lock lock(mutex_);
  if (isWriteDue() || monotonicSeconds() >= nextShow_ || mustEnd()) stop_.store(true);
}

void RenderWatch::run(const std::stop_token& ended) {
  constexpr std::chrono::milliseconds kPeriod{10};
  while (!ended.stop_requested()) {
    look();
    std::this_thread::sleep_for(kPeriod);
  }
}

}  // namespace candela::job
