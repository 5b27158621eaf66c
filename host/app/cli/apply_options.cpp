// CLI11 splits the words after the command; the option table defines their meaning.
#include "host/app/cli/apply_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "host/app/cli/commands.h"
#include "host/app/cli/did_you_mean.h"
#include "host/app/cli/option_groups.h"
#include "host/app/cli/option_table.h"
#include "host/base/errors.h"
#include "host/base/setting_words.h"

namespace candela::cli {
namespace {

[[noreturn]] void refuseUnknownOption(Command command, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  std::vector<std::string> known;
  for (const Option& option : optionTable()) {
    if (option.isFor(command)) {
      known.push_back(option.name());
    } else if (option.name() == name) {
      throw UsageError(fmt::format("{} is not an option of candela {}", name, commandInfo(command).name));
    }
  }
  throw UsageError(fmt::format("unknown option {}{}", name, didYouMean(name, known)));
}

// Returns the first word of a list that is none of the words of the option, with a suggestion; for other options, the
// value.
std::string wrongPart(const Option& option, const std::string& value) {
  std::istringstream parts(value);
  for (std::string part; !option.words.empty() && std::getline(parts, part, ',');) {
    if (std::ranges::find(option.words, part) != option.words.end()) continue;
    return fmt::format("\"{}\"{}", part, didYouMean(part, option.words));
  }
  return fmt::format("\"{}\"", value);
}

// For several values, `apply` decides whether the last one or all of them are used.
CLI::Option* declare(CLI::App& app, const Option& option) {
  if (option.isFlag()) return app.add_flag(option.names);
  return app.add_option(option.names)->expected(1)->allow_extra_args(false)->take_all();
}

// Returns the words in the order that CLI11 requires, the last one first. It would read "-o=FILE" as the file "=FILE".
std::vector<std::string> reversedWords(std::span<const std::string> words) {
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  const auto end = std::ranges::find(words, "--");
  for (auto word = words.begin(); word != end; ++word) {
    const bool isShort = word->size() > 3 && (*word)[0] == '-' && std::isalpha(static_cast<unsigned char>((*word)[1]));
    if (isShort && (*word)[2] == '=') reversed[static_cast<std::size_t>(words.end() - word) - 1].erase(2, 1);
  }
  return reversed;
}

// CLI11 accepts the value of a flag only in the same word.
std::vector<std::string> withJoinedFlags(std::span<const std::string> words) {
  std::vector<std::string> joined;
  bool areOptions = true;
  for (const std::string& word : words) {
    areOptions = areOptions && word != "--";
    if (areOptions && word == kOidn && !joined.empty() && joined.back() == "--denoise") {
      joined.back() += "=" + word;
    } else {
      joined.push_back(word);
    }
  }
  return joined;
}

// Repeats the name of an option that takes several values before each of them, since CLI11 would take the arguments
// after them, too.
std::vector<std::string> withRepeatedNames(const std::vector<std::string>& words, Command command) {
  std::vector<std::string> repeated;
  std::string name;  // of the option that takes the words that follow
  for (const std::string& word : words) {
    if (word.starts_with('-')) {
      const Option* const option = findOption(command, word);
      name = option != nullptr && option->takesSeveral ? word : "";
    } else if (!name.empty() && repeated.back() != name) {
      repeated.push_back(name);
    }
    repeated.push_back(word);
  }
  return repeated;
}

}  // namespace

void setOption(const Option& option, const std::string& value, Arguments& arguments) {
  if (!option.apply(arguments, value)) {
    throw UsageError(fmt::format("{}: expected {}, got {}", settingWords(option.name().substr(2)), option.expected,
                                 wrongPart(option, value)));
  }
  partOf<GeneralArguments>(arguments).given.insert(option.name());
}

void applyOptions(std::span<const std::string> words, Arguments& arguments) {
  const Command command = commandOf(arguments);
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::vector<std::pair<const Option*, CLI::Option*>> declared;
  for (const Option& option : optionTable()) {
    if (option.isFor(command)) declared.emplace_back(&option, declare(app, option));
  }
  app.add_option("files", partOf<GeneralArguments>(arguments).files);

  std::vector<std::string> reversed = reversedWords(withRepeatedNames(withJoinedFlags(words), command));
  try {
    app.parse(reversed);
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string message = error.what();  // "--spp: 1 required ..."
    throw UsageError(message.substr(0, message.find(':')) + " needs a value");
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  for (const std::string& extra : app.remaining()) {
    if (extra != "--") refuseUnknownOption(command, extra);
  }
  for (const auto& [option, parsed] : declared) {
    for (const std::string& value : parsed->results()) setOption(*option, value, arguments);
  }
}

}  // namespace candela::cli
