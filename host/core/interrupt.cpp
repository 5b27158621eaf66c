// Signal handlers that set a flag first, and end the program if the signal comes again later.
#include "host/core/interrupt.h"

#include <time.h>

#include <csignal>

namespace candela {
namespace {

std::atomic<bool> interrupted{false};
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

}  // namespace

const std::atomic<bool>& watchInterrupts() {
  handle(SIGINT, onSignal);
  handle(SIGTERM, onSignal);
  if (!isIgnored(SIGHUP)) handle(SIGHUP, onSignal);
  return interrupted;
}

std::atomic<bool>& watchWriteRequests() {
  handle(SIGUSR1, onWriteRequest);
  return writeRequested;
}

}  // namespace candela
