// Signal handlers that set a flag first, and end the program if the signal comes again later.
#include "host/base/interrupt.h"

#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <csignal>
#include <thread>

namespace candela {
namespace {

std::atomic<bool> interrupted{false};
std::atomic<bool> processorTimeUp{false};
std::atomic<bool> writeRequested{false};
std::atomic<std::int64_t> firstSignalAt[NSIG]{};  ///< by number, in terms of milliseconds(); 0: none
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler must not wait for a lock");

/// Milliseconds of a clock that never goes back. May be called by signal handlers.
std::int64_t milliseconds() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

// Whoever stops a whole process group may also stop a parent that passes the signal on: both are one request.
void onSignal(int number) {
  constexpr std::int64_t kOneRequest = 1000;
  std::int64_t first = 0;
  interrupted.store(true);
  if (firstSignalAt[number].compare_exchange_strong(first, milliseconds())) return;
  if (milliseconds() - first < kOneRequest) return;
  std::signal(number, SIG_DFL);
  std::raise(number);  // ends the program when this handler returns
}

// The kernel repeats this signal after every second of processor time.
void onProcessorTime(int) {
  processorTimeUp.store(true);
  interrupted.store(true);
}

void onWriteRequest(int) { writeRequested.store(true); }

void handle(int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

/// Returns whether the program was started with this signal ignored, as `nohup` does with SIGHUP.
bool isIgnored(int number) {
  struct sigaction action {};
  sigaction(number, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

/// Has SIGXCPU come before the limit at which the kernel kills the process. `ulimit -t` sets both limits to one value.
void leaveProcessorTime() {
  constexpr rlim_t kSecondsPerProcessor = 5;
  rlimit limit{};
  if (::getrlimit(RLIMIT_CPU, &limit) != 0 || limit.rlim_max == RLIM_INFINITY || limit.rlim_cur < limit.rlim_max)
    return;
  const rlim_t margin = std::min<rlim_t>(limit.rlim_max / 10,
                                         kSecondsPerProcessor * std::thread::hardware_concurrency());
  limit.rlim_cur = limit.rlim_max - std::min(limit.rlim_max, std::max<rlim_t>(margin, 1));
  ::setrlimit(RLIMIT_CPU, &limit);
}

}  // namespace

const std::atomic<bool>& watchInterrupts() {
  leaveProcessorTime();
  handle(SIGXCPU, onProcessorTime);
  handle(SIGINT, onSignal);
  handle(SIGTERM, onSignal);
  if (!isIgnored(SIGHUP)) handle(SIGHUP, onSignal);
  return interrupted;
}

bool isProcessorTimeUp() { return processorTimeUp; }

std::atomic<bool>& watchWriteRequests() {
  handle(SIGUSR1, onWriteRequest);
  return writeRequested;
}

}  // namespace candela
