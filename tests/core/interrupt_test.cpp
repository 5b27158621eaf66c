// Ctrl-C sets a flag, once per request.
#include "host/core/interrupt.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <thread>

namespace candela {
namespace {

/// Waits until the monotonic clock has advanced by this time.
void waitFor(std::chrono::milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (std::chrono::steady_clock::now() < end) std::this_thread::sleep_until(end);
}

/// Runs `work` in a child after watchInterrupts(), and returns its wait status. The child exits with 42 if the flag was
/// set.
template <class Work>
int statusAfter(const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    const std::atomic<bool>& stop = watchInterrupts();
    work();
    _exit(stop.load() ? 42 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

bool wasStopped(int status) { return WIFEXITED(status) && WEXITSTATUS(status) == 42; }

// One request to stop may arrive twice. Each child has a second for its copies, or else starts again.
int statusAfterCopies(int signal) {
  for (;;) {
    const auto start = std::chrono::steady_clock::now();
    const int status = statusAfter([&] {
      for (int i = 0; i < 5; ++i) raise(signal);
    });
    if (std::chrono::steady_clock::now() - start < std::chrono::seconds(1)) return status;
  }
}

}  // namespace

TEST_CASE("the first interrupt and its copies set the flag, and one after a second ends the program") {
  const int signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
  CHECK(wasStopped(statusAfter([&] { raise(signal); })));
  CHECK(wasStopped(statusAfterCopies(signal)));
  const int later = statusAfter([&] {
    raise(signal);
    watchInterrupts();  // watching again does not forget the first signal
    waitFor(std::chrono::milliseconds(1001));
    raise(signal);
  });
  REQUIRE(WIFSIGNALED(later));
  CHECK(WTERMSIG(later) == signal);
}

TEST_CASE("signals of different kinds are different requests to the same flag") {
  CHECK(wasStopped(statusAfter([] {
    raise(SIGHUP);
    raise(SIGTERM);
    raise(SIGINT);
  })));
}

TEST_CASE("a program that was started with SIGHUP ignored goes on ignoring it") {
  const int status = statusAfter([] {
    std::signal(SIGHUP, SIG_IGN);  // as nohup does
    watchInterrupts();
    raise(SIGHUP);
  });
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 1);
}

}  // namespace candela
