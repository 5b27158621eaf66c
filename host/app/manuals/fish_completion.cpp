// Completion for fish (its manual, "complete").
#include <fmt/format.h>

#include "host/app/manuals/completion_words.h"
#include "host/app/manuals/completions.h"

namespace candela::manuals {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char character : text) {
    if (character == '\'' || character == '\\') out += '\\';
    if (character != '`') out += character;
  }
  return out + "'";
}

std::string nameFlags(const cli::Option& option) {
  std::string out;
  for (const std::string& name : namesOf(option)) {
    out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  return out;
}

std::string valueFlags(const cli::Option& option) {
  switch (valueKind(option)) {
    case ValueKind::none:
      return " -f";
    case ValueKind::words:
      return " -x -a " + quoted(joined(valuesOf(option)));
    case ValueKind::file:
      return " -r -F";
    case ValueKind::folder:
      return " -x -a '(__fish_complete_directories)'";
    default:
      return " -x";
  }
}

std::string condition(const cli::CommandInfo& info, const std::string& others) {
  if (info.command == cli::Command::render) return fmt::format("not __fish_seen_subcommand_from {}", others);
  return "__fish_seen_subcommand_from " + info.name;
}

}  // namespace

std::string fishCompletion() {
  std::vector<std::string> others;
  std::string out = "# Completion of candela for fish.\n";
  for (const cli::CommandInfo& info : cli::commandTable()) {
    if (info.command != cli::Command::render) others.push_back(info.name);
    out += fmt::format("complete -c candela -n __fish_use_subcommand -a {} -d {}\n", info.name, quoted(info.summary));
  }
  for (const cli::CommandInfo& info : cli::commandTable()) {
    const std::string when = quoted(condition(info, joined(others)));
    const std::vector<std::string> first = firstArguments(info.command);
    if (!first.empty()) out += fmt::format("complete -c candela -n {} -a {}\n", when, quoted(joined(first)));
    for (const cli::Option& option : cli::optionTable()) {
      if (!option.isFor(info.command)) continue;
      out += fmt::format("complete -c candela -n {}{}{} -d {}\n", when, nameFlags(option), valueFlags(option),
                         quoted(option.help));
    }
  }
  return out;
}

}  // namespace candela::manuals
