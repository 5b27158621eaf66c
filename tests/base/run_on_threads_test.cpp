// Work on several threads: exceptions reach the caller, and missing threads are no error.
#include "host/base/run_on_threads.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <thread>

namespace candela {
namespace {

// Takes away the right to start threads; root always has it.
bool forbidThreads() {
  constexpr uid_t kNobody = 65534;
  const rlimit none{0, 0};
  return (geteuid() != 0 || setuid(kNobody) == 0) && setrlimit(RLIMIT_NPROC, &none) == 0;
}

constexpr int kExitCode = 40;  // plus the number of calls, so that no other end of the child looks like it

// Returns kExitCode plus the calls of runOnThreads(8, ...) where no thread can be started; 0 if that cannot be
// arranged. An exception ends the child.
int codeWithoutThreads() noexcept {
  if (!forbidThreads()) return 0;
  std::atomic<int> calls = 0;
  runOnThreads(8, [&](std::uint32_t, const std::stop_token&) { ++calls; });
  return kExitCode + calls;
}

}  // namespace

TEST_CASE("work runs once for each thread, and index 0 on the calling one") {
  std::vector<std::thread::id> threads(5);
  runOnThreads(5, [&](std::uint32_t i, const std::stop_token&) { threads.at(i) = std::this_thread::get_id(); });
  CHECK(threads[0] == std::this_thread::get_id());
  for (std::size_t i = 1; i < threads.size(); ++i) CHECK(threads[i] != std::thread::id());
}

TEST_CASE("an exception of any thread stops the others and reaches the caller") {
  const std::uint32_t failing = GENERATE(0u, 1u, 3u);
  const auto work = [&](std::uint32_t i, const std::stop_token& stop) {
    if (i == failing) throw std::runtime_error("out of tiles");
    while (!stop.stop_requested()) std::this_thread::yield();
  };
  CHECK_THROWS_WITH(runOnThreads(4, work), "out of tiles");
}

TEST_CASE("where the system permits no more threads, the calling thread works alone") {
  const pid_t child = fork();
  if (child == 0) _exit(codeWithoutThreads());
  int status = 0;
  waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == kExitCode + 1);
}

}  // namespace candela
