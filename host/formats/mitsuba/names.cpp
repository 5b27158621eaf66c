// Words suggestions.
#include "host/formats/mitsuba/names.h"

#include <fmt/format.h>

#include "host/base/quote.h"
#include "host/base/suggestion.h"

namespace candela::mitsuba {

std::string suggestionFor(std::string_view word, std::span<const std::string_view> names) {
  constexpr std::size_t kMaxLength = 256;
  if (word.size() > kMaxLength) return {};
  std::vector<scene::Spelling> spellings;
  for (const std::string_view name : names) {
    if (name.size() <= kMaxLength) spellings.push_back({name, name});
  }
  const auto suggestion = scene::suggest(word, spellings);
  return suggestion ? fmt::format("; did you mean {}?", scene::quote(*suggestion)) : std::string();
}

}  // namespace candela::mitsuba
