// From words to Arguments.
#pragma once
#include <span>
#include <string>

#include "host/cli/arguments.h"

namespace candela::cli {

/// `words` are the command line without the program's name. Values and counts of files are checked; files are not
/// looked at. Throws UsageError, which says what was expected, what may have been meant, and where help is.
Arguments parseCommandLine(std::span<const std::string> words);

}  // namespace candela::cli
