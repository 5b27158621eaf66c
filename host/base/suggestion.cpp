// Computes edit distances between words.
#include "host/base/suggestion.h"

#include <algorithm>
#include <numeric>

#include "host/base/lower_case.h"

namespace candela::scene {
namespace {

constexpr std::size_t kMaxWordLength = 24;  ///< longer words are not regarded as misspelt keywords
constexpr std::size_t kMinPrefix = 3;       ///< length from which a word may be the beginning of another

// Returns the keyword that `word` is the beginning of; nothing if there are several.
std::optional<std::string_view> completed(std::string_view word, const std::vector<Spelling>& spellings) {
  std::optional<std::string_view> found;
  for (const Spelling& spelling : spellings) {
    if (!equalsIgnoringCase(word, spelling.word.substr(0, word.size()))) continue;
    if (found && *found != spelling.keyword) return std::nullopt;
    found = spelling.keyword;
  }
  return found;
}

}  // namespace

// Optimal string alignment: three rows of the matrix of Wagner and Fischer, with swaps of neighbours.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool equal = lowerLetter(a[i - 1]) == lowerLetter(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (equal ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lowerLetter(a[i - 1]) == lowerLetter(b[j - 2]) &&
                           lowerLetter(a[i - 2]) == lowerLetter(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
    std::swap(beforeLast, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::optional<std::string_view> suggest(std::string_view word, const std::vector<Spelling>& spellings) {
  if (word.size() > kMaxWordLength) return std::nullopt;
  const std::optional<std::string_view> whole = word.size() < kMinPrefix ? std::nullopt : completed(word, spellings);
  if (whole) return whole;
  std::optional<std::string_view> best;
  std::size_t limit = word.size() / 3 + 1;  // one more than the maximum distance
  for (const Spelling& spelling : spellings) {
    const auto [shorter, longer] = std::minmax({word.size(), spelling.word.size()});
    if (longer - shorter >= limit) continue;  // a lower bound on the distance
    const std::size_t distance = editDistance(word, spelling.word);
    if (distance >= limit) continue;
    limit = distance;
    best = spelling.keyword;
  }
  return best;
}

}  // namespace candela::scene
