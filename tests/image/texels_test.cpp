// Images of textures: what the files store, unchanged, and damaged files.
#include <webp/encode.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <random>

#include "host/base/errors.h"
#include "host/image/codecs.h"
#include "tests/base/temporary_folder.h"
#include "tests/image/test_images.h"

using namespace candela;
using namespace candela::image;

namespace {

using Words = std::vector<std::uint32_t>;

// A chunk of a PNG file with its checksum.
std::string chunk(const std::string& type, const std::string& data) {
  std::string body = type + data;
  std::uint32_t crc = 0xffffffffu;
  for (const char c : body) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1u ? 0xedb88320u : 0u);
  }
  const auto word = [](std::uint32_t value) {
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 255u);
    return text;
  };
  return word(static_cast<std::uint32_t>(data.size())) + body + word(~crc);
}

// A PNG file whose rows, with their filter bytes, are stored without compression. `extra` comes before them.
Bytes storedPng(unsigned width, unsigned height, int bits, int colourType, const std::string& rows,
                const std::string& extra = "") {
  std::string header{0, 0, 0, static_cast<char>(width), 0, 0, 0, static_cast<char>(height)};
  header += {static_cast<char>(bits), static_cast<char>(colourType), 0, 0, 0};
  const auto size = static_cast<std::uint32_t>(rows.size());
  std::string stored("\x78\x01\x01", 3);
  for (const std::uint32_t value : {size & 255u, size >> 8, ~size & 255u, ~size >> 8 & 255u}) {
    stored += static_cast<char>(value);
  }
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char c : rows) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  stored += rows;
  for (const std::uint32_t value : {b >> 8, b & 255u, a >> 8, a & 255u}) stored += static_cast<char>(value);
  return toBytes("\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + extra + chunk("IDAT", stored) + chunk("IEND", ""));
}

Words wordsOf(const Bytes& file) { return decodeTexels(file).rgba; }

Bytes webpOf(std::uint32_t width, std::uint32_t height, const Words& rgba) {
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(reinterpret_cast<const std::uint8_t*>(rgba.data()),
                                                  static_cast<int>(width), static_cast<int>(height),
                                                  static_cast<int>(4 * width), &encoded);
  Bytes bytes(size);
  std::memcpy(bytes.data(), encoded, size);
  WebPFree(encoded);
  return bytes;
}

bool isRefused(const Bytes& file) {
  try {
    const Texels texels = decodeTexels(file);
    REQUIRE(texels.rgba.size() + texels.deepRgba.size() == std::size_t{texels.width} * texels.height);
    return false;
  } catch (const FileError&) {
    return true;
  }
}

// Every truncation is refused, and a few changed bytes do no harm.
void attack(const Bytes& good) {
  REQUIRE_FALSE(isRefused(good));
  for (std::size_t size = 0; size < good.size(); ++size) {
    CAPTURE(size);
    CHECK(isRefused({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)}));
  }
  std::mt19937 random(2);
  for (int round = 0; round < 3000; ++round) {
    Bytes bad = good;
    for (unsigned change = 0; change <= random() % 4; ++change) {
      bad[random() % bad.size()] = static_cast<std::byte>(random());
    }
    isRefused(bad);
  }
}

}  // namespace

TEST_CASE("PNG files keep their channels: colour, grey, alpha, palettes") {
  CHECK(wordsOf(storedPng(2, 1, 8, 2, {0, 1, 2, 3, 4, 5, 6})) == Words{0xff030201u, 0xff060504u});
  CHECK(wordsOf(storedPng(1, 2, 8, 6, {0, 1, 2, 3, 0, 0, 4, 5, 6, 9})) == Words{0x00030201u, 0x09060504u});
  CHECK(wordsOf(storedPng(2, 1, 8, 0, {0, 7, 8})) == Words{0xff070707u, 0xff080808u});
  CHECK(wordsOf(storedPng(2, 1, 8, 4, {0, 7, 1, 8, 2})) == Words{0x01070707u, 0x02080808u});
  CHECK(wordsOf(storedPng(2, 1, 1, 0, {0, 0x40})) == Words{0xff000000u, 0xffffffffu});
  CHECK(wordsOf(storedPng(2, 1, 1, 3, {0, 0x40}, chunk("PLTE", {1, 2, 3, 4, 5, 6}) + chunk("tRNS", {9}))) ==
        Words{0x09030201u, 0xff060504u});
}

TEST_CASE("PNG files of 16 bits keep them") {
  using DeepWords = std::vector<std::uint64_t>;
  const auto deepOf = [](int colourType, const std::string& rows, const std::string& extra = "") {
    const Texels texels = decodeTexels(storedPng(1, 1, 16, colourType, rows, extra));
    CHECK(texels.rgba.empty());
    return texels.deepRgba;
  };
  CHECK(deepOf(2, {0, 1, 2, 3, 4, 5, 6}) == DeepWords{0xffff050603040102u});
  CHECK(deepOf(6, {0, 1, 2, 3, 4, 5, 6, 7, 8}) == DeepWords{0x0708050603040102u});
  CHECK(deepOf(0, {0, 1, 2}) == DeepWords{0xffff010201020102u});
  CHECK(deepOf(4, {0, 1, 2, 3, 4}) == DeepWords{0x0304010201020102u});
  CHECK(deepOf(0, {0, 1, 2}, chunk("tRNS", {1, 2})) == DeepWords{0x0000010201020102u});
}

TEST_CASE("PNG files of 16 bits whose values have 8 are read as those of 8 bits") {
  CHECK(wordsOf(storedPng(1, 1, 16, 2, {0, 1, 1, 3, 3, 5, 5})) == Words{0xff050301u});
  CHECK(wordsOf(storedPng(1, 1, 16, 4, {0, 7, 7, 9, 9})) == Words{0x09070707u});
  CHECK(wordsOf(storedPng(1, 2, 16, 0, {0, 1, 1, 0, 1, 2})).empty());
}

TEST_CASE("the colour space of a PNG file is ignored") {
  const std::string linear = chunk("gAMA", {0, 1, static_cast<char>(0x86), static_cast<char>(0xa0)});
  CHECK(wordsOf(storedPng(1, 1, 8, 2, {0, 10, 100, 77}, linear)) == Words{0xff4d640au});
}

TEST_CASE("JPEG files are opaque") {
  const Pixels8 pixels{16, 16, std::vector<std::uint8_t>(768, 128)};
  for (const std::uint32_t texel : wordsOf(encodeJpeg(pixels))) CHECK(texel == 0xff808080u);
}

TEST_CASE("WebP files keep four channels") {
  const Words texels{0xff030201u, 0x80302010u, 0xffffffffu, 0x01000203u, 0xff000000u, 0x7fabcdefu};
  CHECK(wordsOf(webpOf(3, 2, texels)) == texels);
}

TEST_CASE("damaged files of textures are refused") {
  attack(storedPng(4, 3, 8, 2, std::string(39, 0)));
  attack(storedPng(3, 2, 16, 2, std::string(19, 0) + std::string(19, 1)));
  attack(webpOf(3, 2, {1, 0x80302010u, 3, 4, 5, 6}));
  CHECK(isRefused(toBytes("RIFF\x10\0\0\0WEBPVP8 ")));
  CHECK(isRefused(toBytes("GIF89a")));
  CHECK(isRefused({}));
}
