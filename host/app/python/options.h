// Keyword arguments as options of the command line.
#pragma once
#include <pybind11/pybind11.h>

#include <set>
#include <string>

#include "host/app/cli/option_table.h"

namespace candela::python {

/// The options of a function of the module: those of a command in some groups, and some others by name.
struct FunctionOptions {
  const char* function;  ///< for messages
  cli::Command command;
  std::set<cli::OptionGroup> groups;
  std::set<std::string> besides{};  ///< with their dashes
  std::set<std::string> except{};

  bool has(const cli::Option& option) const;
};

extern const FunctionOptions kLoadOptions, kSceneOptions, kRenderOptions, kSessionOptions, kSequenceOptions,
    kVerifyOptions, kExplainOptions, kCompareTracersOptions, kCompareImagesOptions, kSaveOptions, kDenoiseOptions,
    kMergeOptions;

/// Returns the arguments of the function's command: max_depth=8 is --max-depth 8, and aovs is --aov. A pair
/// or a range is "WxH", "X,Y" or "A:B", True and False are "on" and "off" (or a flag), and None omits an option. Throws
/// UsageError, which names the keyword.
cli::Arguments anyArgumentsOf(const FunctionOptions& function, const pybind11::kwargs& options);
/// Returns the same as the struct of this command, or a part of it.
template <class Part>
Part argumentsOf(const FunctionOptions& function, const pybind11::kwargs& options) {
  cli::Arguments arguments = anyArgumentsOf(function, options);
  return cli::partOf<Part>(arguments);
}

/// Names a setting by its keyword, as messages of libraries do in Python: see setSettingWords().
std::string keywordWords(std::string_view name, std::string_view value);

/// Returns one line for each option: name, values, help and default.
std::string helpOf(const FunctionOptions& function);

}  // namespace candela::python
