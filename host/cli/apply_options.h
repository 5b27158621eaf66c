// Applies the words after the name of a command to its arguments.
#pragma once
#include <span>
#include <string>

#include "host/cli/arguments.h"

namespace candela::cli {
/// Sets the options and files of `arguments`, whose command is known. Values are checked, combinations are not. Throws
/// UsageError with the expected value, a suggestion and a reference to the help.
void applyOptions(std::span<const std::string> words, Arguments& arguments);

}  // namespace candela::cli
