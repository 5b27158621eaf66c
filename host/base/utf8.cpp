// Decodes UTF-8.
#include "host/base/utf8.h"

#include <algorithm>
#include <array>

namespace candela {
namespace {

/// A form of encoded characters.
struct Form {
  unsigned char first, last;              ///< range of the first byte
  unsigned char lowestNext, highestNext;  ///< range of the second byte; the others are 0x80 to 0xbf
  std::size_t length;                     ///< bytes
};

// The rows of table 3-7. They exclude overlong forms, surrogates, and codes above U+10FFFF.
constexpr std::array<Form, 9> kForms{{{0x00, 0x7f, 0, 0, 1},
                                      {0xc2, 0xdf, 0x80, 0xbf, 2},
                                      {0xe0, 0xe0, 0xa0, 0xbf, 3},
                                      {0xe1, 0xec, 0x80, 0xbf, 3},
                                      {0xed, 0xed, 0x80, 0x9f, 3},
                                      {0xee, 0xef, 0x80, 0xbf, 3},
                                      {0xf0, 0xf0, 0x90, 0xbf, 4},
                                      {0xf1, 0xf3, 0x80, 0xbf, 4},
                                      {0xf4, 0xf4, 0x80, 0x8f, 4}}};

constexpr unsigned char byteAt(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

bool hasForm(std::string_view text, const Form& form) {
  if (byteAt(text, 0) < form.first || byteAt(text, 0) > form.last || text.size() < form.length) return false;
  if (form.length > 1 && (byteAt(text, 1) < form.lowestNext || byteAt(text, 1) > form.highestNext)) return false;
  const std::string_view rest = text.substr(0, form.length).substr(std::min<std::size_t>(form.length, 2));
  return std::ranges::all_of(rest, [](char byte) { return (byte & 0xc0) == 0x80; });
}

char32_t codeOf(std::string_view bytes) {
  constexpr std::array<unsigned char, 5> kFirstBits{0, 0x7f, 0x1f, 0x0f, 0x07};  // by length
  char32_t code = byteAt(bytes, 0) & kFirstBits[bytes.size()];
  for (std::size_t i = 1; i < bytes.size(); ++i) code = code << 6 | (byteAt(bytes, i) & 0x3f);
  return code;
}

std::string_view printable(const Utf8Character& character) {
  if (!character.isValid) return kReplacementCharacter;
  if (character.code == U'\t') return " ";
  return isControl(character.code) ? "?" : character.bytes;
}

}  // namespace

Utf8Character firstCharacter(std::string_view text) {
  const auto* const form = std::ranges::find_if(kForms, [&](const Form& one) { return hasForm(text, one); });
  if (form == kForms.end()) return {text.substr(0, 1)};
  const std::string_view bytes = text.substr(0, form->length);
  return {bytes, true, codeOf(bytes)};
}

std::string validUtf8(std::string_view text) {
  std::string valid;
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    valid += character.isValid ? character.bytes : kReplacementCharacter;
    text.remove_prefix(character.bytes.size());
  }
  return valid;
}

std::string printableLine(std::string_view text, std::size_t maxBytes) {
  std::string line;
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    const std::string_view shown = printable(character);
    if (line.size() + shown.size() > maxBytes) break;
    line += shown;
    text.remove_prefix(character.bytes.size());
  }
  return line;
}

}  // namespace candela
