// Writes reports as text.
#pragma once
#include <string>

namespace candela::cli {

/// Writes `text` to a file, or to stdout if `target` is "-", or nowhere if it is empty. Throws FileError.
void writeText(const std::string& target, const std::string& text);

}  // namespace candela::cli
