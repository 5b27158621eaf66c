// Applies the words after the name of a command to its arguments.
#pragma once
#include <span>
#include <string>

#include "host/app/cli/option_table.h"

namespace candela::cli {

/// Sets an option, in the notation of Option::show(); a flag is "true". The command has it. Throws UsageError with
/// the expected value.
void setOption(const Option& option, const std::string& value, Arguments& arguments);

/// Sets the options and files of a command. Values are checked, combinations are not. Throws
/// UsageError with the expected value and a suggestion.
void applyOptions(std::span<const std::string> words, Arguments& arguments);

}  // namespace candela::cli
