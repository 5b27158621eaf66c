// Damaged and hostile image files give a FileError or some image, and nothing else.
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/image/codecs.h"
#include "tests/base/temporary_folder.h"
#include "tests/image/test_images.h"

using namespace candela;
using namespace candela::image;

namespace {

/// True if the bytes decode to an image whose parts fit together, false if they are refused.
template <typename Decode>
bool decodes(Decode decode, ByteView bytes) {
  try {
    const auto image = decode(bytes);
    REQUIRE(image.width > 0);
    REQUIRE(image.height > 0);
    return true;
  } catch (const FileError&) {
    return false;
  }
}

Pixels8 smallPixels() { return toPixels8(testImage(20, 9), {}); }

/// Every truncation, and some thousand files with a few bytes changed, most of them near the start.
template <typename Decode>
void attack(const Bytes& good, Decode decode, std::size_t trailerSize) {
  REQUIRE(decodes(decode, good));
  const std::size_t step = good.size() > 2000 ? 7 : 1;
  for (std::size_t size = 0; size + trailerSize < good.size(); size += step) {
    CAPTURE(size);
    CHECK(!decodes(decode, ByteView(good).first(size)));
  }
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    Bytes bad = good;
    const std::size_t range = round % 2 ? bad.size() : std::min<std::size_t>(bad.size(), 400);
    for (unsigned change = 0; change <= random() % 4; ++change) {
      bad[random() % range] = static_cast<std::byte>(random() % 4 ? random() : 0xffu * (random() % 2));
    }
    decodes(decode, bad);
  }
}

Bytes concatenated(const std::string& head, std::size_t zeros) {
  Bytes bytes = toBytes(head);
  bytes.resize(bytes.size() + zeros);
  return bytes;
}

}  // namespace

TEST_CASE("damaged PNG files are refused") {
  attack(encodePng(smallPixels()), decodePng, 12);  // libpng needs no IEND, whose chunk has 12 bytes
}

TEST_CASE("damaged JPEG files are refused") {
  attack(encodeJpeg(smallPixels()), decodeJpeg, 3);  // the end marker and its padding
}

TEST_CASE("damaged HDR files are refused") { attack(encodeHdr(testImage(20, 9)), decodeHdr, 0); }

TEST_CASE("damaged PFM files are refused") { attack(encodePfm(testImage(20, 9)), decodePfm, 0); }

TEST_CASE("damaged EXR files are refused") {
  Image image = testImage(20, 9);
  image.channels = {{"Z", std::vector<float>(20 * 9, 2)}, {"N.X", std::vector<float>(20 * 9, 0.5f)}};
  for (const ImageParts parts : {ImageParts::picture, ImageParts::withLayers}) {
    attack(
        encodeExr(image), [parts](ByteView file) { return decodeExr(file, parts); }, 0);
  }
}

TEST_CASE("images beyond the limits of size are refused before memory is allocated") {
  CHECK_THROWS_WITH(decodePfm(toBytes("PF 65536 1 -1\n")), Catch::Contains("exceed the limits"));
  CHECK_THROWS_WITH(decodePfm(toBytes("PF 65535 65535 -1\n")), Catch::Contains("exceed the limits"));
  CHECK_THROWS_WITH(decodePfm(toBytes("PF 60000 4000 -1\n")), Catch::Contains("truncated"));
  CHECK_THROWS_WITH(decodePfm(toBytes("PF 0 5 -1\n")), Catch::Contains("no pixels"));
  CHECK_THROWS_AS(decodePfm(toBytes("PF -1 5 -1\n")), FileError);
  CHECK_THROWS_AS(decodePfm(toBytes("PF 99999999999999999999 5 -1\n")), FileError);
  CHECK_THROWS_AS(decodePfm(concatenated("PF 1 1 0\n", 12)), FileError);
  CHECK_THROWS_AS(decodePfm(concatenated("PF 1 1 nan\n", 12)), FileError);
  CHECK_THROWS_WITH(decodeHdr(toBytes("#?RGBE\n\n-Y 70000 +X 5\n")), Catch::Contains("exceed the limits"));
  CHECK_THROWS_AS(decodeHdr(toBytes("#?RGBE\n\n-Y 60000 +X 4000\n")), FileError);
}

TEST_CASE("HDR files of another format, or without a size, are refused with the reason") {
  for (const char* size : {"Y 1 +X 1", "-Z 1 +X 1", "-Y +X 1", "", "-Y 1 +X", "640 480"}) {
    CHECK_THROWS_WITH(decodeHdr(concatenated("#?RGBE\n\n" + std::string(size) + "\n", 4)),
                      Catch::Contains("eight forms"));
  }
  for (const char* size : {"-Y 1 -Y 1", "+X 1 -X 1", "-Y 1 +X 1 5"}) {
    CHECK_THROWS_WITH(decodeHdr(concatenated("#?RGBE\n\n" + std::string(size) + "\n", 4)),
                      Catch::Contains("both a width and a height"));
  }
  CHECK_THROWS_WITH(decodeHdr(concatenated("#?RGBE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n", 4)),
                    Catch::Contains("HDR files of the format 32-bit_rle_xyze are not read"));
  CHECK_THROWS_WITH(decodeHdr(concatenated("#?RGBE\nEXPOSURE=1e-60\nCOLORCORR=1 1e-60 1\n\n-Y 1 +X 1\n", 4)),
                    Catch::Contains("too large or too small"));
  CHECK_THROWS_WITH(decodeHdr(toBytes("#?RGBE\n" + std::string(10000, 'x'))), Catch::Contains("the header has no end"));
}

TEST_CASE("HDR runs that extend beyond their row are refused") {
  using namespace std::string_literals;
  const std::string header = "#?RGBE\n\n-Y 1 +X 8\n";
  const std::string start = "\x02\x02\x00\x08"s;
  CHECK_THROWS_WITH(decodeHdr(toBytes(header + start + "\x89\x01"s)), Catch::Contains("longer than its row"));  // 9
  CHECK_THROWS_WITH(decodeHdr(toBytes(header + start + "\x00"s)), Catch::Contains("longer than its row"));
  CHECK_THROWS_WITH(decodeHdr(toBytes(header + "\x02\x02\x00\x09"s)), Catch::Contains("different width"));
  CHECK_THROWS_WITH(decodeHdr(toBytes(header + "\1\1\1\x05"s)), Catch::Contains("no pixel to repeat"));
  CHECK_THROWS_WITH(decodeHdr(toBytes(header + "\2\3\4\5\1\1\1\x08"s)), Catch::Contains("longer than its row"));
}
