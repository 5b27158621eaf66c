// Ctrl-C sets a flag, once.
#include "host/core/interrupt.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

namespace candela {
namespace {

// Raises `signal` `count` times in a child; its wait status. The child exits with 42 if the flag was set.
int statusAfter(int signal, int count) {
  const pid_t child = fork();
  if (child == 0) {
    const std::atomic<bool>& stop = watchInterrupts();
    for (int i = 0; i < count; ++i) raise(signal);
    _exit(stop.load() ? 42 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

}  // namespace

TEST_CASE("the first interrupt sets the flag and the second ends the program") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  const int once = statusAfter(signal, 1);
  REQUIRE(WIFEXITED(once));
  CHECK(WEXITSTATUS(once) == 42);
  const int twice = statusAfter(signal, 2);
  REQUIRE(WIFSIGNALED(twice));
  CHECK(WTERMSIG(twice) == signal);
}

}  // namespace candela
