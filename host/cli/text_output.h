// Where reports as text go.
#pragma once
#include <string>

namespace candela::cli {

/// Writes `text` to a file, or to stdout if `target` is "-"; nothing if it is empty. Throws FileError.
void writeText(const std::string& target, const std::string& text);

}  // namespace candela::cli
