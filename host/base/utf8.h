// Text of unknown origin, such as messages of drivers, as valid UTF-8.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace candela {

inline constexpr std::string_view kReplacementCharacter = "\xef\xbf\xbd";  ///< U+FFFD in UTF-8

/// A character of UTF-8, or one byte that begins none.
struct Utf8Character {
  std::string_view bytes;  ///< 1 to 4
  bool isValid = false;    ///< as the Unicode Standard defines well-formed UTF-8 (version 15.0, table 3-7)
  char32_t code = 0;       ///< only of a valid character
};

/// Returns the first character of `text`, which is not empty.
Utf8Character firstCharacter(std::string_view text);

/// Returns whether the character is a control character: U+0000 to U+001F and U+007F to U+009F.
constexpr bool isControl(char32_t code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

/// Returns `text` with every byte that is not UTF-8 replaced by U+FFFD.
std::string validUtf8(std::string_view text);

/// Returns `text` as one line for terminals and reports, at most `maxBytes` long: tabs become spaces, other control
/// characters question marks, and bytes that are not UTF-8 U+FFFD.
std::string printableLine(std::string_view text, std::size_t maxBytes);

}  // namespace candela
