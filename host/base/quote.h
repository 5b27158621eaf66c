// Quotes words of a file for messages.
#pragma once
#include <string>
#include <string_view>

namespace candela::scene {

/// Returns the first bytes of UTF-8 text, at most `maxLength` and no part of a character.
inline std::string_view firstBytes(std::string_view text, std::size_t maxLength) {
  if (text.size() <= maxLength) return text;
  std::size_t length = maxLength;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xc0) == 0x80) --length;
  return text.substr(0, length);
}

/// Returns `text` in double quotes, cut to 40 bytes, with anything but printable ASCII and UTF-8 bytes shown as '?', so
/// that a file cannot send control sequences to a terminal.
inline std::string quote(std::string_view text) {
  constexpr std::size_t kMaxLength = 40;
  std::string quoted = "\"";
  for (const char c : firstBytes(text, kMaxLength)) {
    const auto byte = static_cast<unsigned char>(c);
    quoted += byte < 0x20 || byte == 0x7f ? '?' : c;
  }
  return quoted + (text.size() > kMaxLength ? "...\"" : "\"");
}

}  // namespace candela::scene
