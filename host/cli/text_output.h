// Writes reports as text.
#pragma once
#include <iosfwd>
#include <string>

#include "host/cli/arguments.h"

namespace candela::cli {

/// Returns stdout, or stderr if an image is written to stdout.
std::ostream& textStream(const Arguments& arguments);

/// Writes `text` to a file, or to stdout if `target` is "-", or nowhere if it is empty. Throws FileError.
void writeText(const std::string& target, const std::string& text);

}  // namespace candela::cli
