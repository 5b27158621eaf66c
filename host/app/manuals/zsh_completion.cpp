// Completion for zsh (zshcompsys(1): _arguments and _describe).
#include <fmt/format.h>

#include "host/app/manuals/completion_words.h"
#include "host/app/manuals/completions.h"

namespace candela::manuals {
namespace {

// Returns text for a single-quoted argument of _arguments, in which brackets and colons end a field.
std::string fieldText(const std::string& text) {
  std::string out;
  for (const char character : text) {
    if (character == '\'') {
      out += "'\\''";
      continue;
    }
    if (character == '[' || character == ']' || character == ':' || character == '\\') out += '\\';
    if (character != '`') out += character;
  }
  return out;
}

std::string action(const cli::Option& option) {
  switch (valueKind(option)) {
    case ValueKind::none:
      return "";
    case ValueKind::words:
      return fmt::format(":value:({})", joined(valuesOf(option)));
    case ValueKind::file:
      return ":file:_files";
    case ValueKind::folder:
      return ":folder:_files -/";
    default:
      return ":value: ";
  }
}

std::string commandFunction(const cli::CommandInfo& info) {
  std::string out = fmt::format("_candela_{}() {{\n  _arguments -S \\\n", info.name);
  for (const cli::Option& option : cli::optionTable()) {
    if (!option.isFor(info.command)) continue;
    for (const std::string& name : namesOf(option)) {
      out += fmt::format("    '*{}[{}]{}' \\\n", name, fieldText(option.help), action(option));
    }
  }
  const std::vector<std::string> first = firstArguments(info.command);
  if (!first.empty()) out += fmt::format("    '1:first:__candela_first {}' \\\n", joined(first));
  return out + "    '*:file:_files'\n}\n";
}

constexpr const char* kZshTail = R"(__candela_first() {
  compadd -- "$@"
  _files
}
_candela() {
  if ((CURRENT > 2)) && (($+functions[_candela_${words[2]}])); then
    local name=${words[2]}
    shift words
    ((CURRENT--))
    _candela_$name
    return
  fi
  if ((CURRENT == 2)) && [[ $PREFIX != -* ]]; then
    __candela_commands
    _files
    return
  fi
  _candela_render
}
if [[ $funcstack[1] == _candela ]]; then _candela "$@"; else compdef _candela candela; fi
)";

}  // namespace

std::string zshCompletion() {
  std::string
      out = "#compdef candela\n# Completion of candela for zsh.\n__candela_commands() {\n  local -a names\n  names=(\n";
  for (const cli::CommandInfo& info : cli::commandTable()) {
    out += fmt::format("    '{}:{}'\n", info.name, fieldText(info.summary));
  }
  out += "  )\n  _describe command names\n}\n";
  for (const cli::CommandInfo& info : cli::commandTable()) out += commandFunction(info);
  return out + kZshTail;
}

}  // namespace candela::manuals
