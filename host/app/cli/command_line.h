// Parses the command line.
#pragma once
#include <span>
#include <string>

#include "host/app/cli/command_arguments.h"

namespace candela::cli {

/// `words` is the command line without the name of the program. Values and numbers of files are checked; files are not
/// opened. From now on, messages name settings by their options. Throws UsageError with the expected value, a
/// suggestion and a reference to the help.
Arguments parseCommandLine(std::span<const std::string> words);

}  // namespace candela::cli
