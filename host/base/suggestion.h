// Suggestions for misspelt keywords.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

namespace candela::scene {

/// A word that people write, and the keyword that they mean.
struct Spelling {
  std::string_view word;
  std::string_view keyword;
};

/// Returns the number of edits (insertion, deletion, replacement, swap of neighbours) that turn `a` into `b`, ignoring
/// ASCII case.
std::size_t editDistance(std::string_view a, std::string_view b);

/// Returns the only keyword that begins with `word`, of at least three characters. If there is none, returns the
/// keyword of the spelling nearest to `word`, if its distance is at most a third of the length of the word; the first
/// of several nearest spellings.
std::optional<std::string_view> suggest(std::string_view word, const std::vector<Spelling>& spellings);

}  // namespace candela::scene
