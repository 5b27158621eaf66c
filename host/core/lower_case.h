// ASCII letters in lower case. Other bytes stay as they are.
#pragma once
#include <algorithm>
#include <string>

namespace candela {

constexpr char lowerLetter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; }

inline std::string lowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), lowerLetter);
  return text;
}

}  // namespace candela
