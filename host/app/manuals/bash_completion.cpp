// Completion for bash (its manual, "Programmable Completion").
#include <fmt/format.h>

#include "host/app/manuals/completion_words.h"
#include "host/app/manuals/completions.h"

namespace candela::manuals {
namespace {

constexpr const char* kBashHead = R"(# Completion of candela for bash.
_candela() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command=render options= first= i
  COMPREPLY=()
  case ${COMP_WORDS[1]} in
)";

constexpr const char* kBashTail = R"(  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
    return
  fi
  COMPREPLY=($(compgen -f -- "$word"))
  if ((COMP_CWORD == 1)); then COMPREPLY+=($(compgen -W "$commands" -- "$word")); fi
  if ((COMP_CWORD == 2)); then COMPREPLY+=($(compgen -W "$first" -- "$word")); fi
}
complete -o filenames -F _candela candela
)";

std::string commandCases() {
  std::string names;
  for (const cli::CommandInfo& info : cli::commandTable()) names += (names.empty() ? "" : "|") + info.name;
  std::string out = fmt::format("    {}) command=${{COMP_WORDS[1]}} ;;\n  esac\n  case $command in\n", names);
  for (const cli::CommandInfo& info : cli::commandTable()) {
    std::vector<std::string> options;
    for (const cli::Option& option : cli::optionTable()) {
      if (!option.isFor(info.command)) continue;
      for (const std::string& name : namesOf(option)) options.push_back(name);
    }
    out += fmt::format("    {})\n      options='{}'\n      first='{}'\n      ;;\n", info.name, joined(options),
                       joined(firstArguments(info.command)));
  }
  return out + "  esac\n";
}

std::string valueReply(const cli::Option& option) {
  switch (valueKind(option)) {
    case ValueKind::words:
      return fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$word\"))", joined(valuesOf(option)));
    case ValueKind::file:
      return "COMPREPLY=($(compgen -f -- \"$word\"))";
    case ValueKind::folder:
      return "COMPREPLY=($(compgen -d -- \"$word\"))";
    default:
      return ":";
  }
}

std::string valueCases() {
  std::string out = "  case $command:$previous in\n";
  for (const cli::CommandInfo& info : cli::commandTable()) {
    for (const cli::Option& option : cli::optionTable()) {
      if (!option.isFor(info.command) || option.isFlag()) continue;
      std::string pattern;
      for (const std::string& name : namesOf(option)) pattern += (pattern.empty() ? "" : "|") + info.name + ":" + name;
      out += fmt::format("    {}) {}; return ;;\n", pattern, valueReply(option));
    }
  }
  return out + "  esac\n";
}

}  // namespace

std::string bashCompletion() {
  std::vector<std::string> commands;
  for (const cli::CommandInfo& info : cli::commandTable()) commands.push_back(info.name);
  return kBashHead + commandCases() + valueCases() + fmt::format("  local commands='{}'\n", joined(commands)) +
         kBashTail;
}

}  // namespace candela::manuals
