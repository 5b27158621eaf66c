// Runs the real program like a user, and captures its output.
#pragma once
#include <signal.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "tests/base/temporary_folder.h"

namespace candela {

struct ProgramResult {
  int exitCode = -1;  ///< -1: ended by a signal
  std::string out;
  std::string err;
};

struct Surroundings {
  std::vector<std::string> environment{};  ///< added, "NAME=value"
  std::string standardOutput{};            ///< a file to write to instead of catching it
  /// `signal` (Ctrl-C) is sent after this time. All signals but SIGKILL wait until the program handles them: on a
  /// loaded machine, it may not have started by then, and the signal would end it.
  std::optional<std::chrono::milliseconds> interruptAfter{};
  int signal = SIGINT;
  /// SIGUSR1 is sent after each of these times, from `writeRequestsFrom` on, as soon as the program handles it.
  std::optional<std::chrono::milliseconds> writeRequestsEvery{};
  std::chrono::milliseconds writeRequestsFrom{0};
};

/// Surroundings for command lines that load the machine's drivers. Drivers leak when they are unloaded, in modules that
/// the leak sanitizer can then no longer name to suppress them.
inline Surroundings withDrivers() { return {.environment = {"ASAN_OPTIONS=detect_leaks=0"}}; }

/// Runs candela with `words`, stdin empty, without stored tuning unless the surroundings have it. Throws
/// std::runtime_error if it cannot be started or takes over five minutes.
ProgramResult runCandela(const std::vector<std::string>& words, const Surroundings& surroundings = {});

/// Runs another program, given by its path.
ProgramResult runProgram(const std::string& program, const std::vector<std::string>& words,
                         const Surroundings& surroundings = {});

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A diffuse ball on a floor under a light, 16x12 pixels; `extra` lines are appended.
std::string smallScene(const std::string& extra = "");

}  // namespace candela
