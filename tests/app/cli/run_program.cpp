// posix_spawn with output to files, since those never fill up.
#include "tests/app/cli/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <sstream>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace candela {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::minutes kMaxRunTime{5};

// posix_spawn takes char*, and changes nothing.
void append(std::vector<char*>& pointers, const std::vector<std::string>& words) {
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
}

pid_t spawn(const std::string& program, const std::vector<std::string>& words, const std::vector<std::string>& added,
            const std::string& out, const std::string& err) {
  std::vector<char*> arguments{const_cast<char*>(program.c_str())};
  append(arguments, words);
  arguments.push_back(nullptr);
  std::vector<char*> environment;
  append(environment, added);
  const auto isReplaced = [&](const std::string& entry) {
    const std::string name = entry.substr(0, entry.find('=') + 1);
    return std::ranges::any_of(added, [&](const std::string& other) { return other.starts_with(name); });
  };
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (!isReplaced(*entry)) environment.push_back(*entry);
  }
  environment.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const int failure = posix_spawn(&child, program.c_str(), &actions, nullptr, arguments.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::runtime_error("cannot start " + program);
  return child;
}

/// Returns whether the program has a handler of the signal (proc(5)). Until then, most signals would end it.
bool handlesSignal(pid_t program, int signal) {
  std::istringstream status(readText("/proc/" + std::to_string(program) + "/status"));
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("SigCgt:")) return std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1;
  }
  return false;
}

int waitFor(pid_t child, const Surroundings& surroundings) {
  const Clock::time_point start = Clock::now();
  bool interrupted = !surroundings.interruptAfter;
  Clock::duration nextRequest = surroundings.writeRequestsFrom;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    const auto elapsed = Clock::now() - start;
    if (!interrupted && elapsed >= *surroundings.interruptAfter &&
        (surroundings.signal == SIGKILL || handlesSignal(child, surroundings.signal))) {
      kill(child, surroundings.signal);
      interrupted = true;
    }
    if (surroundings.writeRequestsEvery && elapsed >= nextRequest && handlesSignal(child, SIGUSR1)) {
      kill(child, SIGUSR1);
      nextRequest = elapsed + *surroundings.writeRequestsEvery;
    }
    if (elapsed > kMaxRunTime) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      throw std::runtime_error("a program took too long");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

ProgramResult runCandela(const std::vector<std::string>& words, const Surroundings& surroundings) {
  return runProgram(CANDELA_PROGRAM, words, surroundings);
}

ProgramResult runProgram(const std::string& program, const std::vector<std::string>& words,
                         const Surroundings& surroundings) {
  const TemporaryFolder folder;
  const std::string out = surroundings.standardOutput.empty() ? folder.path("out") : surroundings.standardOutput;
  std::vector<std::string> environment = surroundings.environment;
  environment.push_back("CANDELA_CACHE_DIR=" + folder.path("cache"));
  const pid_t child = spawn(program, words, environment, out, folder.path("err"));
  ProgramResult result;
  result.exitCode = waitFor(child, surroundings);
  result.out = readText(folder.path("out"));
  result.err = readText(folder.path("err"));
  return result;
}

std::string smallScene(const std::string& extra) {
  return "v\nfrom 0 -4 1\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 16 12\n"
         "b 0.1 0.2 0.3\n"
         "f 0.8 0.6 0.4 1 0 0 0 0 1 1 1\n"
         "s 0 0 0 0.5\n"
         "p 4\n-3 -3 -0.5\n3 -3 -0.5\n3 3 -0.5\n-3 3 -0.5\n"
         "f 1 1 1 1 0 0 0 0 1 1 1 4 4 4\n"
         "s 1 -1 2 0.4\n" +
         extra;
}

}  // namespace candela
