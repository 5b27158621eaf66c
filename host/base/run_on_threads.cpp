// Starts the threads, and stores the first exception.
#include "host/base/run_on_threads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace candela {
namespace {

using Work = std::function<void(std::uint32_t, const std::stop_token&)>;

class GuardedWork {
 public:
  explicit GuardedWork(const Work& work) : work_(work) {}

  void run(std::uint32_t index) {
    try {
      work_(index, stop_.get_token());
    } catch (...) {
      stop_.request_stop();
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const Work& work_;
  std::stop_source stop_;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

// If the system permits no more threads, the running threads and the calling thread do the work.
void startHelpers(std::uint32_t count, GuardedWork& work, std::vector<std::jthread>& helpers) {
  try {
    for (std::uint32_t i = 1; i < count; ++i) helpers.emplace_back([&work, i] { work.run(i); });
  } catch (const std::system_error&) {
  } catch (const std::bad_alloc&) {
  }
}

}  // namespace

void runOnThreads(std::uint32_t count, const Work& work) {
  GuardedWork guarded(work);
  {
    std::vector<std::jthread> helpers;  // joined at the end of the block
    startHelpers(count, guarded, helpers);
    guarded.run(0);
  }
  guarded.rethrow();
}

void forEachOnThreads(std::uint32_t threadCount, std::size_t count,
                      const std::function<void(std::uint32_t thread, std::size_t i)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto takeAll = [&](std::uint32_t thread, const std::stop_token& stop) {
    for (std::size_t i = next++; i < count && !stop.stop_requested(); i = next++) work(thread, i);
  };
  runOnThreads(static_cast<std::uint32_t>(std::clamp<std::size_t>(count, 1, threadCount)), takeAll);
}

std::uint32_t threadCountFor(std::uint32_t asked) {
  return asked > 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

void forEachBlock(std::uint32_t threadCount, std::size_t count,
                  const std::function<void(std::size_t begin, std::size_t end)>& work) {
  constexpr std::size_t kBlockSize = 1u << 14;
  forEachOnThreads(threadCount, (count + kBlockSize - 1) / kBlockSize,
                   [&](std::uint32_t, std::size_t i) { work(i * kBlockSize, std::min((i + 1) * kBlockSize, count)); });
}

}  // namespace candela
