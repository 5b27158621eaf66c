// BMP and TGA images of textures: exact texels of files written by hand, and damaged files.
#include <catch2/catch.hpp>
#include <string>

#include "host/base/errors.h"
#include "host/image/codecs.h"

using namespace candela;
using namespace candela::image;

namespace {

using Words = std::vector<std::uint32_t>;

constexpr std::uint32_t kRed = 0xff0000ffu, kGreen = 0xff00ff00u, kBlue = 0xffff0000u, kWhite = 0xffffffffu,
                        kBlack = 0xff000000u;

std::string shortWord(std::uint32_t value) { return {static_cast<char>(value & 255), static_cast<char>(value >> 8)}; }
std::string word(std::uint32_t value) { return shortWord(value & 65535) + shortWord(value >> 16); }
std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

Bytes fileOf(const std::string& text) {
  const auto view = std::as_bytes(std::span(text));
  return {view.begin(), view.end()};
}
Words wordsOf(const std::string& file) { return decodeModelTexels(fileOf(file)).rgba; }

// `extra` follows the fields of a header of 40 bytes: masks, or what is left of longer ones.
std::string bmp(std::int32_t width, std::int32_t height, int bits, const std::string& palette, const std::string& data,
                std::uint32_t compression = 0, const std::string& extra = "", std::uint32_t longer = 0) {
  const auto offset = static_cast<std::uint32_t>(54 + extra.size() + palette.size());
  return "BM" + word(static_cast<std::uint32_t>(offset + data.size())) + word(0) + word(offset) + word(40 + longer) +
         word(static_cast<std::uint32_t>(width)) + word(static_cast<std::uint32_t>(height)) + shortWord(1) +
         shortWord(static_cast<std::uint32_t>(bits)) + word(compression) + word(0) + word(0) + word(0) +
         word(static_cast<std::uint32_t>(palette.size() / 4)) + word(0) + extra + palette + data;
}

std::string tga(int type, int bits, int descriptor, const std::string& data, const std::string& palette = "") {
  const int colours = static_cast<int>(palette.size() / 3);
  return bytes({0, colours > 0 ? 1 : 0, type, 0, 0, colours, 0, colours > 0 ? 24 : 0, 0, 0, 0, 0, 2, 0, 2, 0, bits,
                descriptor}) +
         palette + data;
}

const std::string kFourColours = bytes({0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255});  // red green blue white

}  // namespace

TEST_CASE("BMP files of 24 bits begin with their last row, unless the height is negative") {
  const std::string padded = kFourColours.substr(0, 6) + "xx" + kFourColours.substr(6) + "xx";
  CHECK(wordsOf(bmp(2, 2, 24, "", padded)) == Words{kBlue, kWhite, kRed, kGreen});
  CHECK(wordsOf(bmp(2, -2, 24, "", padded)) == Words{kRed, kGreen, kBlue, kWhite});
}

TEST_CASE("BMP files may have palettes of 1, 4 and 8 bits") {
  const std::string palette = bytes({0, 0, 255, 0, 0, 255, 0, 0});
  CHECK(wordsOf(bmp(3, 1, 1, palette, bytes({0x40, 0, 0, 0}))) == Words{kRed, kGreen, kRed});
  CHECK(wordsOf(bmp(3, 1, 4, palette, bytes({0x01, 0x10, 0, 0}))) == Words{kRed, kGreen, kGreen});
  CHECK(wordsOf(bmp(3, 1, 8, palette, bytes({1, 0, 9, 0}))) == Words{kGreen, kRed, kBlack});
  const std::string core = "BM" + word(0) + word(0) + word(26 + 6) + word(12) + shortWord(2) + shortWord(1) +
                           shortWord(1) + shortWord(1) + bytes({0, 0, 255, 255, 0, 0}) + bytes({0x40, 0, 0, 0});
  CHECK(wordsOf(core) == Words{kRed, kBlue});
}

TEST_CASE("BMP files of 16 and 32 bits may have masks, of which alpha is one") {
  CHECK(wordsOf(bmp(2, 1, 16, "", shortWord(0x7c00) + shortWord(0x03e0))) == Words{kRed, kGreen});
  const std::string rgb565 = word(0xf800) + word(0x07e0) + word(0x001f);
  CHECK(wordsOf(bmp(2, 1, 16, "", shortWord(0x001f) + shortWord(0x8410), 3, rgb565)) == Words{kBlue, 0xff848284u});
  CHECK(wordsOf(bmp(1, 1, 32, "", word(0x00ff0000))) == Words{kRed});
  const std::string rgba = word(0xff) + word(0xff00) + word(0xff0000) + word(0xff000000);
  CHECK(wordsOf(bmp(1, 1, 32, "", word(0x80030201), 3, rgba, 16)) == Words{0x80030201u});
}

TEST_CASE("TGA files begin with the row and the column that their descriptor states") {
  CHECK(wordsOf(tga(2, 24, 0, kFourColours)) == Words{kBlue, kWhite, kRed, kGreen});
  CHECK(wordsOf(tga(2, 24, 32, kFourColours)) == Words{kRed, kGreen, kBlue, kWhite});
  CHECK(wordsOf(tga(2, 24, 48, kFourColours)) == Words{kGreen, kRed, kWhite, kBlue});
}

TEST_CASE("TGA files have palettes, grey, colours of 16 and 32 bits, and runs") {
  CHECK(wordsOf(tga(1, 8, 32, bytes({3, 2, 1, 0}), kFourColours)) == Words{kWhite, kBlue, kGreen, kRed});
  CHECK(wordsOf(tga(3, 8, 32, bytes({0, 255, 128, 1}))) == Words{kBlack, kWhite, 0xff808080u, 0xff010101u});
  CHECK(wordsOf(tga(2, 16, 32, shortWord(0x7c00) + shortWord(0x03e0) + shortWord(0x801f) + shortWord(0x7fff))) ==
        Words{kRed, kGreen, kBlue, kWhite});
  CHECK(wordsOf(tga(2, 16, 33, shortWord(0x7c00) + shortWord(0x83e0) + shortWord(0x801f) + shortWord(0xffff)))[0] ==
        0x000000ffu);
  const std::string texel = bytes({1, 2, 3, 4});
  CHECK(wordsOf(tga(10, 32, 40, bytes({0x82}) + texel + bytes({0}) + bytes({9, 8, 7, 6}))) ==
        Words{0x04010203u, 0x04010203u, 0x04010203u, 0x06090807u});
  CHECK(wordsOf(tga(2, 32, 32, texel + texel + texel + texel))[0] == 0xff010203u);  // without bits of alpha
}

TEST_CASE("damaged BMP and TGA files are refused") {
  for (const std::string& file :
       {bmp(2, 2, 24, "", kFourColours + "xxxx"), bmp(3, 1, 4, bytes({0, 0, 255, 0}), bytes({0x01, 0x10, 0, 0})),
        bmp(1, 1, 32, "", word(1), 3, word(0xff) + word(0xff00) + word(0xff0000)), tga(2, 24, 0, kFourColours),
        tga(10, 32, 40, bytes({0x83, 1, 2, 3, 4})), tga(1, 8, 32, bytes({3, 2, 1, 0}), kFourColours)}) {
    CHECK_NOTHROW(wordsOf(file));
    for (std::size_t length = 0; length < file.size(); ++length) {
      CHECK_THROWS_AS(wordsOf(file.substr(0, length)), FileError);
    }
  }
  CHECK_THROWS_WITH(wordsOf(bmp(2, 2, 8, "", "", 1)), Catch::Contains("a compressed BMP file"));
  CHECK_THROWS_WITH(wordsOf(bmp(2, 2, 7, "", "")), Catch::Contains("7 bits per pixel"));
  CHECK_THROWS_AS(wordsOf(bmp(0, 2, 24, "", "")), FileError);
  CHECK_THROWS_AS(wordsOf(bmp(30000, INT32_MIN, 24, "", "")), FileError);
  CHECK_THROWS_WITH(wordsOf(tga(1, 8, 32, bytes({4, 2, 1, 0}), kFourColours)), Catch::Contains("no colour 4"));
  CHECK_THROWS_WITH(wordsOf("solid cube"), "not a PNG, JPEG, WebP, BMP or TGA file");
  CHECK_THROWS_AS(decodeTexels(fileOf(bmp(2, 2, 24, "", kFourColours + "xxxx"))), FileError);  // glTF has none
}
