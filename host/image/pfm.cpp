// Reads and writes portable float maps (Paul Debevec): a text header, then binary32 rows from bottom to top.
#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "host/image/byte_cursor.h"

namespace candela::image {
namespace {

/// Each word of the header ends in exactly one white space character.
template <typename Number>
Number takeNumber(ByteCursor& cursor) {
  const std::string_view word = cursor.takeUntil(
      [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) throw FileError("not a valid PFM header");
  return number;
}

float toFloat(const std::byte* bytes, bool littleEndian) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i) {
    const int shift = 8 * (littleEndian ? i : 3 - i);
    bits |= std::to_integer<std::uint32_t>(bytes[i]) << shift;
  }
  return std::bit_cast<float>(bits);
}

void appendLittleEndian(Bytes& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::byte>(bits >> shift));
}

}  // namespace

Image decodePfm(ByteView file) {
  ByteCursor cursor(file);
  const bool grey = cursor.takeUntil([](char c) { return c == '\n' || c == ' ' || c == '\r'; }) == "Pf";
  const auto width = takeNumber<std::uint32_t>(cursor);
  const auto height = takeNumber<std::uint32_t>(cursor);
  const auto scale = takeNumber<double>(cursor);
  if (!std::isfinite(scale) || scale == 0) throw FileError("not a valid PFM header");
  checkImageSize(width, height);

  const std::size_t pixelBytes = grey ? 4 : 12;
  const ByteView data = cursor.take(pixelBytes * width * height);
  Image image{width, height, std::vector<glm::vec3>(std::size_t{width} * height), {}, {}, {}, {}};
  const bool littleEndian = scale < 0;
  const auto factor = static_cast<float>(std::abs(scale));
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::byte* pixel = data.data() + pixelBytes * (std::size_t{row} * width + x);
      const float red = toFloat(pixel, littleEndian);
      const glm::vec3 colour = grey
                                   ? glm::vec3(red)
                                   : glm::vec3(red, toFloat(pixel + 4, littleEndian), toFloat(pixel + 8, littleEndian));
      image.at(x, height - 1 - row) = factor * colour;
    }
  }
  return image;
}

Bytes encodePfm(const Image& image) {
  const std::string header = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
  Bytes bytes(header.size());
  std::memcpy(bytes.data(), header.data(), header.size());
  bytes.reserve(header.size() + 12 * image.rgb.size());
  for (std::uint32_t y = image.height; y-- > 0;) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const glm::vec3& pixel = image.at(x, y);
      appendLittleEndian(bytes, pixel.x);
      appendLittleEndian(bytes, pixel.y);
      appendLittleEndian(bytes, pixel.z);
    }
  }
  return bytes;
}

}  // namespace candela::image
