// Joins the groups of options to the option table.
#include "host/app/cli/option_table.h"

#include <algorithm>

#include "host/app/cli/option_groups.h"

namespace candela::cli {

const std::vector<Option>& optionTable() {
  static const std::vector<Option> table = [] {
    std::vector<Option> all;
    for (const auto& part : {imageOptions(), sceneFileOptions(), sequenceOptions(), executionOptions(), outputOptions(),
                             filmOptions(), comparisonOptions(), verificationOptions(), conformanceOptions(),
                             captureOptions(), explanationOptions(), benchmarkOptions(), kernelOptions(),
                             tuningOptions(), generationOptions(), viewingOptions(), generalOptions()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return table;
}

const Option* findOption(Command command, const std::string& name) {
  const auto found = std::ranges::find_if(
      optionTable(), [&](const Option& option) { return option.isFor(command) && option.name() == name; });
  return found == optionTable().end() ? nullptr : &*found;
}

std::vector<std::string> valuesOf(const Arguments& arguments, const std::string& name) {
  const Option* const option = findOption(commandOf(arguments), name);
  return option == nullptr ? std::vector<std::string>{} : option->show(arguments);
}

std::string commandLineOf(const Arguments& arguments, OptionGroup group, bool onlyChanged) {
  std::string line;
  for (const Option& option : optionTable()) {
    if (option.group != group || !option.isFor(commandOf(arguments))) continue;
    for (const std::string& value : option.show(arguments)) {
      if (value.empty() || (onlyChanged && value == option.defaultText)) continue;
      if (!line.empty()) line += ' ';
      line += option.name();
      if (!option.isFlag()) line.append(1, ' ').append(shellQuoted(value));
    }
  }
  return line;
}

std::string optionWords(std::string_view name, std::string_view value) {
  if (name == "output") return "-o";
  const std::string words = "--" + std::string(name);
  const auto found = std::ranges::find(optionTable(), words, &Option::name);
  const bool isFlag = found != optionTable().end() && found->isFlag();
  return value.empty() || isFlag ? words : words + ' ' + shellQuoted(std::string(value));
}

std::string shellQuoted(const std::string& word) {
  if (!word.empty() && word.find_first_not_of(kPlainCharacters) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char character : word) {
    if (character == '\'') {
      quoted += "'\\''";
    } else {
      quoted += character;
    }
  }
  return quoted + "'";
}

}  // namespace candela::cli
