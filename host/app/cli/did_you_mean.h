// Suggestions for mistyped words on the command line.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace candela::cli {

/// Returns the end of a message, e.g. "; did you mean balls?"; empty if no candidate is similar.
std::string didYouMean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace candela::cli
