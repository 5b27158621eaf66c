// Quotes words of a file for messages.
#pragma once
#include <string>
#include <string_view>

namespace candela::scene {

/// Returns `text` in double quotes, cut to 40 bytes, with anything but printable ASCII and UTF-8 bytes shown as '?', so
/// that a file cannot send control sequences to a terminal.
inline std::string quote(std::string_view text) {
  constexpr std::size_t kMaxLength = 40;
  std::string quoted = "\"";
  for (const char c : text.substr(0, kMaxLength)) {
    const auto byte = static_cast<unsigned char>(c);
    quoted += byte < 0x20 || byte == 0x7f ? '?' : c;
  }
  return quoted + (text.size() > kMaxLength ? "...\"" : "\"");
}

}  // namespace candela::scene
