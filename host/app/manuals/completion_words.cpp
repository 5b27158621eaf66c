// Splits metavars into words.
#include "host/app/manuals/completion_words.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "host/scene/generate/kinds.h"

namespace candela::manuals {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

bool isWord(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

}  // namespace

std::vector<std::string> valuesOf(const cli::Option& option) {
  std::vector<std::string> values = split(option.metavar, '|');
  std::erase_if(values, [](const std::string& value) { return !isWord(value); });
  return values;
}

ValueKind valueKind(const cli::Option& option) {
  if (option.isFlag()) return ValueKind::none;
  if (option.metavar == "FILE") return ValueKind::file;
  if (option.metavar == "DIR") return ValueKind::folder;
  return valuesOf(option).empty() ? ValueKind::other : ValueKind::words;
}

std::vector<std::string> namesOf(const cli::Option& option) { return split(option.names, ','); }

std::vector<std::string> firstArguments(cli::Command command) {
  std::vector<std::string> words;
  if (command == cli::Command::generate) {
    for (const generate::Kind& kind : generate::kindTable()) words.emplace_back(kind.name);
  }
  if (command == cli::Command::bench) words = {"table1", "accel", "rays", "compare", "error"};
  return words;
}

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

}  // namespace candela::manuals
