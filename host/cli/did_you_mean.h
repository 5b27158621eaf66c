// Suggestions for mistyped words of the command line.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace candela::cli {

/// E.g. "; did you mean balls?", to end a message with; empty if no candidate is near.
std::string didYouMean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace candela::cli
