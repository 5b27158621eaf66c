// Ctrl-C sets a flag, once per request.
#include "host/base/interrupt.h"

#include <signal.h>
#include <sys/resource.h>
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

TEST_CASE("the signal of the limit of processor time sets the flag, however often it comes") {
  const int status = statusAfter([] {
    if (isProcessorTimeUp()) _exit(2);
    raise(SIGXCPU);
    waitFor(std::chrono::milliseconds(1001));
    raise(SIGXCPU);
    if (!isProcessorTimeUp()) _exit(3);
  });
  CHECK(wasStopped(status));
}

TEST_CASE("a limit of processor time that kills without notice is announced before") {
  const auto softLimitAfterWatching = [](rlim_t soft, rlim_t hard) {
    const pid_t child = fork();
    if (child == 0) {
      rlimit limit{soft, hard};
      setrlimit(RLIMIT_CPU, &limit);
      watchInterrupts();
      watchInterrupts();
      getrlimit(RLIMIT_CPU, &limit);
      _exit(static_cast<int>(limit.rlim_cur));
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WEXITSTATUS(status);
  };
  CHECK(softLimitAfterWatching(60, 60) == 54);
  CHECK(softLimitAfterWatching(4, 4) == 3);
  CHECK(softLimitAfterWatching(50, 60) == 50);
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
