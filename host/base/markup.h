// Text in HTML and XML.
#pragma once
#include <string>
#include <string_view>

#include "host/base/utf8.h"

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

/// Returns `text` as content or attribute of HTML and XML, with `replacement` for each character whose code
/// `isRefused`, and U+FFFD for each byte that is not UTF-8.
template <class Predicate>
std::string escaped(std::string_view text, std::string_view replacement, Predicate isRefused) {
  std::string out;
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    const std::string_view entity = entityOf(text.front());
    if (!entity.empty()) {
      out += entity;
    } else if (!character.isValid) {
      out += kReplacementCharacter;
    } else {
      out += isRefused(character.code) ? replacement : character.bytes;
    }
    text.remove_prefix(character.bytes.size());
  }
  return out;
}

/// Returns `text` as content or attribute of XML 1.0. Characters that XML does not permit (control characters, U+FFFE
/// and U+FFFF) become spaces, and so do tabs and carriage returns, but not newlines.
inline std::string xmlEscaped(std::string_view text) {
  return escaped(text, " ",
                 [](char32_t code) { return (code < ' ' && code != '\n') || code == 0xfffe || code == 0xffff; });
}

/// Returns the element for a failed test case of a JUnit report. The text is an attribute, whose line breaks parsers
/// replace by spaces, and content, where they stay.
inline std::string junitFailure(std::string_view type, std::string_view text) {
  const std::string escapedText = xmlEscaped(text);
  return "<failure type=\"" + xmlEscaped(type) + "\" message=\"" + escapedText + "\">" + escapedText + "</failure>";
}

}  // namespace candela
