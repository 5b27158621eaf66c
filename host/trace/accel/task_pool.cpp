// One queue that is emptied from its end, so that the halves of a large task are processed first.
#include "host/trace/accel/task_pool.h"

#include <system_error>
#include <thread>
#include <utility>

namespace candela::accel {

TaskPool::TaskPool(std::uint32_t threadCount) {
  try {
    for (std::uint32_t i = 1; i < threadCount; ++i) threads_.emplace_back([this] { work(); });
  } catch (const std::system_error&) {
    // If the system permits no more threads, the running threads and the waiting thread do the work.
  }
}

TaskPool::~TaskPool() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
}

void TaskPool::submit(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    queue_.push_back(std::move(task));
    ++unfinishedCount_;
  }
  changed_.notify_one();
}

void TaskPool::wait() {
  std::unique_lock lock(mutex_);
  while (unfinishedCount_ > 0) {
    if (queue_.empty()) {
      changed_.wait(lock, [this] { return !queue_.empty() || unfinishedCount_ == 0; });
      continue;
    }
    runOne(lock);
  }
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void TaskPool::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return !queue_.empty() || closing_; });
    if (closing_) return;
    runOne(lock);
  }
}

void TaskPool::runOne(std::unique_lock<std::mutex>& lock) {
  std::function<void()> task = std::move(queue_.back());
  queue_.pop_back();
  lock.unlock();
  std::exception_ptr failure;
  try {
    task();
  } catch (...) {
    failure = std::current_exception();
  }
  task = nullptr;
  lock.lock();
  if (failure && !failure_) failure_ = failure;
  if (failure_) {
    unfinishedCount_ -= queue_.size();
    queue_.clear();
  }
  if (--unfinishedCount_ == 0) changed_.notify_all();
}

}  // namespace candela::accel
