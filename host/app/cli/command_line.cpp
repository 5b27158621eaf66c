// Recognises the command.
#include "host/app/cli/command_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/cli/apply_options.h"
#include "host/app/cli/argument_checks.h"
#include "host/app/cli/commands.h"
#include "host/app/cli/did_you_mean.h"
#include "host/app/cli/option_table.h"
#include "host/base/errors.h"
#include "host/base/setting_words.h"

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

// Removes the command from `words`, and returns its arguments. Without a command, `render` is assumed.
Arguments takeCommand(std::span<const std::string>& words) {
  const CommandInfo* const info = commandNamed(words.front());
  if (info == nullptr) {
    refuseMistypedCommand(words.front());
    return {};
  }
  words = words.subspan(1);
  Arguments arguments = defaultArguments(info->command);
  partOf<GeneralArguments>(arguments).commandNamed = true;
  return arguments;
}

Arguments helpFor(std::span<const std::string> words) {
  Arguments arguments;
  if (!words.empty()) {
    arguments = takeCommand(words);
    if (!partOf<GeneralArguments>(arguments).commandNamed)
      throw UsageError(fmt::format("unknown command {}\nsee candela --help", words.front()));
  }
  partOf<GeneralArguments>(arguments).help = true;
  return arguments;
}

// A scene is read from stdin under the name that the system gives it.
void nameStdin(Arguments& arguments) {
  auto* const scenes = findPart<SceneArguments>(arguments);
  if (scenes != nullptr) std::ranges::replace(scenes->files, std::string("-"), std::string("/dev/stdin"));
}

}  // namespace

Arguments parseCommandLine(std::span<const std::string> words) {
  setSettingWords(&optionWords);
  if (words.empty()) throw UsageError("no scene given\nsee candela --help");
  if (asksForHelp(words)) return helpFor(words.subspan(1));
  Arguments arguments = takeCommand(words);
  try {
    applyOptions(words, arguments);
    const GeneralArguments& general = partOf<GeneralArguments>(arguments);
    if (general.help || general.version) return arguments;
    nameStdin(arguments);
    checkArguments(arguments);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}\nsee candela {} --help", error.what(), commandInfo(commandOf(arguments)).name));
  }
  return arguments;
}

}  // namespace candela::cli
