// Recognises the command.
#include "host/cli/command_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/cli/apply_options.h"
#include "host/cli/argument_checks.h"
#include "host/cli/commands.h"
#include "host/cli/did_you_mean.h"
#include "host/cli/option_groups.h"
#include "host/core/errors.h"
#include "host/core/setting_words.h"

namespace candela::cli {
namespace {

// A word like "rendr" is regarded as a mistyped command rather than a scene, if it does not look like a path and no
// such file exists.
void refuseMistypedCommand(const std::string& word) {
  std::error_code ignored;
  if (word.find_first_of("./-") != std::string::npos || std::filesystem::exists(word, ignored)) return;
  std::vector<std::string> names;
  for (const CommandInfo& info : commandTable()) names.push_back(info.name);
  const std::string meant = didYouMean(word, names);
  if (!meant.empty()) throw UsageError(fmt::format("unknown command {}{}\nsee candela --help", word, meant));
}

const CommandInfo* commandNamed(const std::string& word) {
  for (const CommandInfo& info : commandTable()) {
    if (word == info.name) return &info;
  }
  return nullptr;
}

// `candela help [COMMAND]` and `candela --help COMMAND`
bool asksForHelp(std::span<const std::string> words) {
  if (words.front() == "help") return true;
  const bool isOption = words.front() == "--help" || words.front() == "-h";
  return isOption && words.size() > 1 && commandNamed(words[1]) != nullptr;
}

// Removes the command from `words`. Without a command, `render` is assumed.
void takeCommand(std::span<const std::string>& words, Arguments& arguments) {
  const CommandInfo* const info = commandNamed(words.front());
  if (info == nullptr) return refuseMistypedCommand(words.front());
  words = words.subspan(1);
  arguments.command = info->command;
  arguments.commandNamed = true;
}

Arguments helpFor(std::span<const std::string> words) {
  Arguments arguments;
  arguments.help = true;
  if (words.empty()) return arguments;
  takeCommand(words, arguments);
  if (!arguments.commandNamed) throw UsageError(fmt::format("unknown command {}\nsee candela --help", words.front()));
  return arguments;
}

// A scene is read from stdin under the name that the system gives it.
void nameStdin(Arguments& arguments) {
  if ((static_cast<unsigned>(arguments.command) & kReadingScenes) == 0) return;
  std::ranges::replace(arguments.files, std::string("-"), std::string("/dev/stdin"));
}

}  // namespace

Arguments parseCommandLine(std::span<const std::string> words) {
  setSettingWords(&optionWords);
  if (words.empty()) throw UsageError("no scene given\nsee candela --help");
  if (asksForHelp(words)) return helpFor(words.subspan(1));
  Arguments arguments;
  takeCommand(words, arguments);
  try {
    applyOptions(words, arguments);
    if (arguments.help || arguments.version) return arguments;
    nameStdin(arguments);
    checkArguments(arguments);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}\nsee candela {} --help", error.what(), commandInfo(arguments.command).name));
  }
  return arguments;
}

}  // namespace candela::cli
