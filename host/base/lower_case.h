// ASCII letters in lower case, and comparisons that ignore their case. Other bytes stay as they are.
#pragma once
#include <algorithm>
#include <string>
#include <string_view>

namespace candela {

constexpr char lowerLetter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; }

inline std::string lowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), lowerLetter);
  return text;
}

inline bool equalsIgnoringCase(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, lowerLetter, lowerLetter);
}

}  // namespace candela
