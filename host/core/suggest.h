// Guesses which word was meant.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candela {

/// The candidate with the fewest edits (insertion, deletion, substitution, swap of neighbours) from `word`, the first
/// of equals; none if even that is more than a third of the longer of both words.
std::optional<std::string> nearestWord(std::string_view word, std::span<const std::string> candidates);

}  // namespace candela
