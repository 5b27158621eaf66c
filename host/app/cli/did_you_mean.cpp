// Writes the suggestion for a mistyped word.
#include "host/app/cli/did_you_mean.h"

#include <fmt/format.h>

#include "host/base/suggestion.h"

namespace candela::cli {

std::string didYouMean(std::string_view word, const std::vector<std::string>& candidates) {
  std::vector<scene::Spelling> spellings;
  for (const std::string& candidate : candidates) spellings.push_back({candidate, candidate});
  const auto meant = suggest(word, spellings);
  return meant ? fmt::format("; did you mean {}?", *meant) : "";
}

}  // namespace candela::cli
