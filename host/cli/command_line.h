// Parses the command line.
#pragma once
#include <span>
#include <string>

#include "host/cli/arguments.h"

namespace candela::cli {

/// `words` is the command line without the name of the program. Values and numbers of files are checked; files are not
/// opened. Throws UsageError with the expected value, a suggestion and a reference to the help.
Arguments parseCommandLine(std::span<const std::string> words);

/// Parses the words after the name of a command for a caller that has the files in memory and takes the result itself,
/// so that neither files nor outputs are required. Throws as parseCommandLine() does.
Arguments parseOptions(Command command, std::span<const std::string> words);

}  // namespace candela::cli
