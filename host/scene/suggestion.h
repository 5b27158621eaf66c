// What a misspelt keyword may have been meant to be.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

namespace candela::scene {

/// A word that people write, and the keyword they would have needed.
struct Spelling {
  std::string_view word;
  std::string_view keyword;
};

/// Edits (insert, delete, replace, swap of neighbours) that turn `a` into `b`, ignoring ASCII case.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The keyword of the spelling nearest to `word`, if it is near: within a third of the word's length. The first of
/// equally near ones wins.
std::optional<std::string_view> suggest(std::string_view word, const std::vector<Spelling>& spellings);

}  // namespace candela::scene
