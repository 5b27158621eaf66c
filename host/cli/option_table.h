// The one place where options are declared. A name may have several rows, each for other commands. Parsing, help,
// README's block, the settings in reports and the commands that replay a sample are all made from this table.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "host/cli/arguments.h"

namespace candela::cli {

enum class OptionGroup {
  image,
  sceneFile,
  execution,
  output,
  comparison,
  verification,
  explanation,
  benchmark,
  tuning,
  generation,
  general
};

struct Option {
  std::string names;  ///< e.g. "-t,--threads"
  unsigned commands;  ///< those that take it, a sum of Command values
  OptionGroup group;
  std::string help;                                           ///< no capital, no full stop
  std::string metavar;                                        ///< empty: a flag
  std::string expected;                                       ///< completes "expected ..."
  std::string defaultText;                                    ///< of default-constructed Arguments; empty: none
  std::function<bool(Arguments&, const std::string&)> apply;  ///< false if the value cannot be read
  /// The value as `apply` reads it (or the words of help for an absent one); a repeatable option has several, an unset
  /// flag none.
  std::function<std::vector<std::string>(const Arguments&)> show;

  /// The long name, with its dashes.
  std::string name() const { return names.substr(names.rfind(',') + 1); }
  bool isFlag() const { return metavar.empty(); }
  bool isFor(Command command) const { return (commands & static_cast<unsigned>(command)) != 0; }
};

const std::vector<Option>& optionTable();

/// The options of `group` as a command line would state them, e.g. "--spp 16 --seed 0 --one-sided". With
/// `onlyChanged` those at their default are left out. Values are quoted for a shell where they need it.
std::string commandLineOf(const Arguments& arguments, OptionGroup group, bool onlyChanged);

/// `word` as a POSIX shell reads it back.
std::string shellQuoted(const std::string& word);

}  // namespace candela::cli
