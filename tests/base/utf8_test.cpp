// Valid and invalid UTF-8.
#include "host/base/utf8.h"

#include <catch2/catch.hpp>
#include <vector>

#include "host/base/markup.h"

namespace candela {

TEST_CASE("characters of one to four bytes are decoded") {
  struct Known {
    std::string bytes;
    char32_t code;
  };
  for (const Known& known : std::vector<Known>{{"A", U'A'},
                                               {"\x7f", 0x7f},
                                               {"\xc2\x80", 0x80},
                                               {"\xdf\xbf", 0x7ff},
                                               {"\xe0\xa0\x80", 0x800},
                                               {"\xed\x9f\xbf", 0xd7ff},
                                               {"\xee\x80\x80", 0xe000},
                                               {"\xef\xbf\xbf", 0xffff},
                                               {"\xf0\x90\x80\x80", 0x10000},
                                               {"\xf4\x8f\xbf\xbf", 0x10ffff}}) {
    const std::string text = known.bytes + "x";
    const Utf8Character character = firstCharacter(text);
    CAPTURE(known.bytes);
    CHECK(character.isValid);
    CHECK(character.bytes == known.bytes);
    CHECK(character.code == known.code);
  }
}

TEST_CASE("a byte that begins no character of UTF-8 is one invalid character") {
  for (const std::string text : {"\x80", "\xc0\x80", "\xc1\xbf", "\xc3", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xe2\x82",
                                 "\xe2\x82x", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff"}) {
    CAPTURE(text);
    const Utf8Character character = firstCharacter(text);
    CHECK_FALSE(character.isValid);
    CHECK(character.bytes == text.substr(0, 1));
  }
}

TEST_CASE("every byte that is not UTF-8 becomes U+FFFD in valid text") {
  CHECK(validUtf8("Ger\xe4t") == "Ger\xef\xbf\xbdt");
  CHECK(validUtf8("\xc3(\xe2\x82\n") == "\xef\xbf\xbd(\xef\xbf\xbd\xef\xbf\xbd\n");
  CHECK(validUtf8("Ger\xc3\xa4t") == "Ger\xc3\xa4t");
}

TEST_CASE("a printable line has no control characters, is valid, and ends with a whole character") {
  CHECK(printableLine("\x1b[31mred\x07\t\xff\xfe caf\xc3\xa9 \xc2\x9b\x7f", 100) ==
        "?[31mred? \xef\xbf\xbd\xef\xbf\xbd caf\xc3\xa9 ??");
  CHECK(printableLine("ab\xc3\xa9z", 4) == "ab\xc3\xa9");
  CHECK(printableLine("ab\xc3\xa9z", 3) == "ab");
  CHECK(printableLine(std::string("a\0b", 3), 10) == "a?b");
  CHECK(printableLine("", 10).empty());
}

TEST_CASE("XML has only the characters that it permits") {
  CHECK(xmlEscaped("a<b\n\t\x1b\xff \xef\xbf\xbe\xef\xbf\xbf \xc3\xa9") == "a&lt;b\n  \xef\xbf\xbd    \xc3\xa9");
}

}  // namespace candela
