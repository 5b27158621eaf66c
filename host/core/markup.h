// Characters with a special meaning in HTML and XML.
#pragma once
#include <string>
#include <string_view>

namespace candela {

/// Returns the entity for the character in content and in quoted attributes of HTML and XML, or an empty string if none
/// is needed.
constexpr std::string_view entityOf(char character) {
  switch (character) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

/// Returns `text` as content or attribute of HTML and XML, with `replacement` for each character that `isRefused`.
template <class Predicate>
std::string escaped(std::string_view text, std::string_view replacement, Predicate isRefused) {
  std::string out;
  for (const char character : text) {
    const std::string_view entity = entityOf(character);
    if (!entity.empty()) {
      out += entity;
    } else if (isRefused(character)) {
      out += replacement;
    } else {
      out += character;
    }
  }
  return out;
}

/// Returns `text` as content or attribute of XML. Control characters except newlines become spaces.
inline std::string xmlEscaped(std::string_view text) {
  return escaped(text, " ", [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\n'; });
}

}  // namespace candela
