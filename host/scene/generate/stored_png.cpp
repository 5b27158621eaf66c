// Chunks with their checksums, and a zlib stream of stored blocks (RFC 1950 and 1951).
#include "host/scene/generate/stored_png.h"

#include <algorithm>
#include <string_view>

namespace candela::generate {
namespace {

using Bytes = std::vector<std::byte>;

void append(Bytes& bytes, std::uint32_t word) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::byte>(word >> shift));
}

void append(Bytes& bytes, std::string_view text) {
  for (const char character : text) bytes.push_back(static_cast<std::byte>(character));
}

std::uint32_t crcOf(const std::byte* begin, const std::byte* end) {
  std::uint32_t crc = 0xffffffffu;
  for (; begin != end; ++begin) {
    crc ^= std::to_integer<std::uint32_t>(*begin);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
  }
  return ~crc;
}

void appendChunk(Bytes& file, std::string_view type, const Bytes& content) {
  append(file, static_cast<std::uint32_t>(content.size()));
  const std::size_t begin = file.size();
  append(file, type);
  file.insert(file.end(), content.begin(), content.end());
  append(file, crcOf(file.data() + begin, file.data() + file.size()));
}

std::uint32_t adlerOf(const Bytes& bytes) {
  std::uint32_t a = 1, b = 0;
  for (const std::byte byte : bytes) {
    a = (a + std::to_integer<std::uint32_t>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

Bytes zlibStored(const Bytes& bytes) {
  constexpr std::size_t kMaxBlock = 65535;
  Bytes stream{std::byte{0x78}, std::byte{0x01}};
  for (std::size_t at = 0; at < bytes.size(); at += kMaxBlock) {
    const std::size_t size = std::min(kMaxBlock, bytes.size() - at);
    const bool isLast = at + size == bytes.size();
    stream.push_back(std::byte{isLast});
    for (const std::size_t word : {size, ~size}) {
      stream.push_back(static_cast<std::byte>(word & 0xff));
      stream.push_back(static_cast<std::byte>(word >> 8 & 0xff));
    }
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    stream.insert(stream.end(), from, from + static_cast<std::ptrdiff_t>(size));
  }
  append(stream, adlerOf(bytes));
  return stream;
}

}  // namespace

Bytes storedPng(std::uint32_t width, std::uint32_t height, const Bytes& rgb) {
  Bytes header;
  append(header, width);
  append(header, height);
  for (const int value : {8, 2, 0, 0, 0}) header.push_back(static_cast<std::byte>(value));  // 8-bit RGB
  Bytes rows;
  for (std::uint32_t y = 0; y < height; ++y) {
    rows.push_back(std::byte{0});  // no filter
    const auto row = rgb.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{width} * y);
    rows.insert(rows.end(), row, row + 3 * static_cast<std::ptrdiff_t>(width));
  }
  Bytes file;
  append(file, "\x89PNG\r\n\x1a\n");
  appendChunk(file, "IHDR", header);
  appendChunk(file, "IDAT", zlibStored(rows));
  appendChunk(file, "IEND", {});
  return file;
}

}  // namespace candela::generate
