// The table of all options. A name may have several rows, each for other commands. Parsing, help, manual pages,
// completions, the settings in reports and the commands that replay a sample are derived from this table.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "host/app/cli/command_arguments.h"

namespace candela::cli {

enum class OptionGroup {
  image,
  sceneFile,
  sequence,
  execution,
  film,
  output,
  comparison,
  verification,
  conformance,
  capture,
  explanation,
  benchmark,
  kernels,
  tuning,
  generation,
  viewing,
  general
};

/// The value of --denoise for Open Image Denoise.
inline constexpr const char* kOidn = "oidn";

/// `apply` and `show` throw std::bad_variant_access for the arguments of another command.
struct Option {
  std::string names;  ///< e.g. "-t,--threads"
  unsigned commands;  ///< commands that have the option, a sum of Command values
  OptionGroup group;
  std::string help;                                           ///< no capital, no full stop
  std::string metavar;                                        ///< empty: a flag
  std::string expected;                                       ///< completes "expected ..."
  std::string defaultText;                                    ///< value in default-constructed arguments; empty: none
  std::function<bool(Arguments&, const std::string&)> apply;  ///< returns false if the value is invalid
  /// Returns the value in the notation of `apply` (or the words in help for an empty one). A repeatable option has
  /// several values, an unset flag none.
  std::function<std::vector<std::string>(const Arguments&)> show;
  std::vector<std::string> words{};  ///< Notation::words
  bool takesSeveral = false;         ///< all words up to the next option are values

  /// Returns whether a value as films record it ("off" for a flag that is not given) is the default.
  bool isDefault(const std::string& value) const { return value == (isFlag() ? "off" : defaultText); }

  /// Returns whether a word of `show` is a value, rather than words that describe a default ("the pose at rest").
  bool isValue(const std::string& word) const { return word != defaultText || word.find(' ') == std::string::npos; }

  /// Returns the long name with its dashes.
  std::string name() const { return names.substr(names.rfind(',') + 1); }
  bool isFlag() const { return metavar.empty(); }
  bool isFor(Command command) const { return (commands & static_cast<unsigned>(command)) != 0; }
};

const std::vector<Option>& optionTable();

/// Returns the option of a command by its long name, with its dashes; null if the command has none of this name.
const Option* findOption(Command command, const std::string& name);

/// Returns the values of an option by its long name, as Option::show() does; none if the command lacks the option.
std::vector<std::string> valuesOf(const Arguments& arguments, const std::string& name);

/// Returns the options of `group` that the command has in the notation of a command line, e.g. "--spp 16 --seed 0
/// --one-sided", without those at their default if `onlyChanged`. Values are quoted for a shell if necessary.
std::string commandLineOf(const Arguments& arguments, OptionGroup group, bool onlyChanged);

/// The characters that have no meaning to a POSIX shell, wherever they are in a word.
inline constexpr std::string_view
    kPlainCharacters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-+/=:,@%";

/// Returns `word` quoted for a POSIX shell.
std::string shellQuoted(const std::string& word);

/// Names a setting by its option, as messages of libraries do in this program: see setSettingWords().
std::string optionWords(std::string_view name, std::string_view value);

}  // namespace candela::cli
