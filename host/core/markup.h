// Characters that mean something in HTML and XML.
#pragma once
#include <string_view>

namespace candela {

/// What stands for the character in content and in quoted attributes of HTML and XML; empty if it may stand for itself.
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
