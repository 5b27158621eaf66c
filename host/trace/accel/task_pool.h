// Runs tasks that may start further tasks, on a fixed number of threads.
#pragma once
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace candela::accel {

/// Threads run from construction to destruction. The thread that calls wait() works too, so that `threadCount` 1 starts
/// no thread. Tasks run in no particular order.
class TaskPool {
 public:
  explicit TaskPool(std::uint32_t threadCount);
  ~TaskPool();
  TaskPool(const TaskPool&) = delete;
  TaskPool& operator=(const TaskPool&) = delete;

  /// Adds a task. May be called from any thread and from within a task.
  void submit(std::function<void()> task);
  /// Returns when all tasks are done, including those that they submitted. Rethrows the first exception of a task;
  /// tasks that have not started by then are dropped.
  void wait();

 private:
  void work();
  void runOne(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::function<void()>> queue_;
  std::size_t unfinishedCount_ = 0;  ///< number of tasks that are queued or running
  std::exception_ptr failure_;
  bool closing_ = false;
  std::vector<std::jthread> threads_;  ///< last member: joined before the others are destroyed
};

}  // namespace candela::accel
