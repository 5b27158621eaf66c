// Maps the command line to a command and the command to an exit code. It is the only place that catches errors.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <new>

#include "host/app/cli/command_line.h"
#include "host/app/cli/commands.h"
#include "host/app/cli/help.h"
#include "host/app/cli/separate_files.h"
#include "host/base/log.h"
#include "host/base/memory_budget.h"
#include "host/base/standard_output.h"
#include "host/base/version.h"
#include "host/trace/vulkan/unfinished_work.h"
#include "host/trace/vulkan/validation.h"

namespace candela {
namespace {

ExitCode runCommand(const std::vector<std::string>& words) {
  const cli::Arguments arguments = cli::parseCommandLine(words);
  const auto& general = cli::partOf<cli::GeneralArguments>(arguments);
  if (general.help) {
    const auto command = general.commandNamed ? std::optional(cli::commandOf(arguments)) : std::nullopt;
    std::cout << cli::helpText(command, cli::helpWidth()) << std::flush;
    return ExitCode::done;
  }
  if (general.version) {
    std::cout << "candela " << versionText() << std::endl;
    return ExitCode::done;
  }
  cli::requireSeparateFiles(arguments);
  const auto* const memory = cli::findPart<cli::MemoryArguments>(arguments);
  if (memory != nullptr && memory->memory) limitMemory(*memory->memory);
  const Log log(std::cerr, general.verbosity());
  return std::visit([&](const auto& command) { return cli::run(command, log); }, arguments);
}

// Output that could not be written is a failure.
ExitCode afterOutput(ExitCode code) {
  if (std::cout.flush()) return code;
  throw StdoutError();
}

// Every message of the validation layer is an error of the program, whatever the image looks like.
ExitCode afterValidation(ExitCode code) {
  const std::vector<std::string> messages = vulkan::validationMessages();
  const Log log(std::cerr, Verbosity::quiet);
  for (const std::string& message : messages) log.problem("validation: " + message);
  return messages.empty() ? code : ExitCode::internal;
}

ExitCode fail(ExitCode code, const std::string& message) {
  Log(std::cerr, Verbosity::quiet).problem(message);
  return code;
}

ExitCode run(const std::vector<std::string>& words) {
  try {
    return afterValidation(afterOutput(runCommand(words)));
  } catch (const StdoutError& error) {
    // Whoever closed the pipe needs no message.
    return afterValidation(isStdoutAbandoned() ? error.code() : fail(error.code(), error.what()));
  } catch (const Error& error) {
    return afterValidation(fail(error.code(), error.what()));
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::outOfMemory, "out of memory");
  } catch (const std::exception& error) {
    return fail(ExitCode::internal, fmt::format("internal error: {}", error.what()));
  }
}

}  // namespace
}  // namespace candela

int main(int argc, char** argv) {
  // A file beyond `ulimit -f` and a pipe that nobody reads are errors of write() like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  const int code = static_cast<int>(candela::run(std::vector<std::string>(argv + std::min(argc, 1), argv + argc)));
  // Threads of a driver that are still at work must not see libraries being unloaded.
  if (candela::vulkan::hasUnfinishedWork()) std::_Exit(code);
  return code;
}
