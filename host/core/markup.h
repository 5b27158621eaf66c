// Characters with a special meaning in HTML and XML.
#pragma once
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

}  // namespace candela
