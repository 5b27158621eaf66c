// Work in a child process: its result, and every kind of failure.
#include "host/drivers/child_process.h"

#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "host/trace/vulkan/validation.h"
#include "host/trace/vulkan/validation_log.h"

namespace candela::process {
namespace {

using nlohmann::json;

constexpr std::chrono::seconds kLongLimit{60};

}  // namespace

TEST_CASE("a child returns JSON of any size") {
  const std::string text(1'000'000, 'x');
  const ChildResult result = runInChild(kLongLimit, [&] { return json{{"text", text}}; });
  CHECK(result.failure.empty());
  CHECK(result.answer["text"] == text);
}

TEST_CASE("a child that crashes is a failure with the name of the signal and the last line") {
  const ChildResult aborted = runInChild(kLongLimit, []() -> json {
    std::fputs("first\nlast\n\n", stderr);
    std::fflush(stderr);
    ::raise(SIGABRT);
    return 1;
  });
  CHECK(aborted.failure == "crashes (Aborted)");
  CHECK(aborted.lastMessage == "last");
  CHECK(aborted.answer.is_null());
  const ChildResult killed = runInChild(kLongLimit, []() -> json { return ::raise(SIGKILL); });
  CHECK(killed.failure == "crashes (Killed)");
}

TEST_CASE("a child that exits without a result is a failure, even with exit code 0") {
  for (const int code : {9, 0}) {
    const ChildResult result = runInChild(kLongLimit, [code]() -> json { ::_exit(code); });
    CHECK(result.failure == "ends the program with exit code " + std::to_string(code));
    ChildProcess child(kLongLimit, [code](const ChildProcess::Send& send) {
      send("a value");
      ::_exit(code);
    });
    while (!child.hasEnded()) child.receive();
    CHECK(child.failure() == result.failure);
  }
  ChildProcess good(kLongLimit, [](const ChildProcess::Send& send) { send("a value"); });
  std::size_t count = 0;
  while (!good.hasEnded()) count += good.receive().size();
  CHECK(count == 1);
  CHECK(good.failure().empty());
}

TEST_CASE("the last line of a child is printable, whatever bytes a driver prints") {
  const auto lastLineOf = [](const std::string& text) {
    return runInChild(kLongLimit,
                      [&]() -> json {
                        std::fwrite(text.data(), 1, text.size(), stderr);
                        std::abort();
                      })
        .lastMessage;
  };
  CHECK(lastLineOf("first\n\x1b[31mbad \xff\xfe driver\x0c\r\n \n") == "?[31mbad \xef\xbf\xbd\xef\xbf\xbd driver?");
  CHECK(lastLineOf("x" + std::string(1023, '.') + "\n") == "x" + std::string(1023, '.'));
  std::string accents = "begin";
  for (int i = 0; i < 2000; ++i) accents += "\xc3\xa9";
  CHECK(lastLineOf("first\n" + accents + "\n") == accents.substr(0, 1023));
  CHECK(lastLineOf(std::string(200'000, '\n') + "last").substr(0, 4) == "last");
  CHECK(lastLineOf("\n \n").empty());
}

TEST_CASE("an exception in a child is a failure with its message") {
  const ChildResult result = runInChild(kLongLimit, []() -> json { throw std::runtime_error("out of wax"); });
  CHECK(result.failure == "fails: out of wax");
}

TEST_CASE("a child that hangs is ended after the limit") {
  const auto start = std::chrono::steady_clock::now();
  const ChildResult result = runInChild(std::chrono::milliseconds(300), []() -> json {
    std::this_thread::sleep_for(std::chrono::minutes(2));
    return 1;
  });
  CHECK(result.failure == "does not end within 0.3 s");
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::minutes(1));
}

TEST_CASE("a child that hangs is ended soon after the flag is set") {
  static std::atomic<bool> stop{false};
  std::signal(SIGALRM, [](int) { stop = true; });
  const itimerval soon{{}, {0, 200'000}};
  ::setitimer(ITIMER_REAL, &soon, nullptr);
  const auto start = std::chrono::steady_clock::now();
  const ChildResult result = runInChild(
      kLongLimit,
      []() -> json {
        std::this_thread::sleep_for(std::chrono::minutes(2));
        return 1;
      },
      &stop);
  std::signal(SIGALRM, SIG_DFL);
  CHECK(result.interrupted);
  CHECK(result.failure == "is interrupted");
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(30));
  CHECK_FALSE(runInChild(kLongLimit, []() -> json { return 1; }).interrupted);
}

TEST_CASE("messages of the validation layer in a child are those of the program") {
  vulkan::clearValidationMessages();
  runInChild(kLongLimit, []() -> json {
    vulkan::addValidationMessage("a wrong call");
    return nullptr;
  });
  CHECK(vulkan::validationMessages() == std::vector<std::string>{"a wrong call"});
  vulkan::clearValidationMessages();
}

}  // namespace candela::process
