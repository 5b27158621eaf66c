// Signal handlers that set a flag once and then restore the default action.
#include "host/core/interrupt.h"

#include <csignal>

namespace candela {
namespace {

std::atomic<bool> interrupted{false};
std::atomic<bool> writeRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

void onSignal(int) { interrupted.store(true); }
void onWriteRequest(int) { writeRequested.store(true); }

}  // namespace

const std::atomic<bool>& watchInterrupts() {
  struct sigaction action {};
  action.sa_handler = onSignal;
  // The first signal restores the default action: a second Ctrl-C ends the program even if it hangs.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return interrupted;
}

std::atomic<bool>& watchWriteRequests() {
  struct sigaction action {};
  action.sa_handler = onWriteRequest;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGUSR1, &action, nullptr);
  return writeRequested;
}

}  // namespace candela
