// Reads BMP files without compression, which old models have as textures.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "host/base/errors.h"
#include "host/image/byte_cursor.h"

namespace candela::image {
namespace {

constexpr std::uint32_t kFileHeader = 14, kCoreHeader = 12, kInfoHeader = 40, kHeaderWithAlpha = 56, kMaxHeader = 124;
enum Compression : std::uint32_t { kNone = 0, kBitFields = 3, kAlphaBitFields = 6 };

struct BmpHeader {
  std::uint32_t dataOffset = 0;
  std::uint32_t size = 0;  ///< of the header after that of the file
  std::uint32_t width = 0, height = 0;
  bool isTopDown = false;
  std::uint32_t bits = 0;  ///< of a pixel
  std::uint32_t compression = kNone;
  std::uint32_t colours = 0;             ///< of the palette; 0: as many as the bits can name
  std::array<std::uint32_t, 4> masks{};  ///< of red, green, blue and alpha in a pixel of 16 or 32 bits
};

void readSides(std::uint32_t width, std::uint32_t height, BmpHeader& header) {
  const auto signedHeight = static_cast<std::int32_t>(height);
  header.isTopDown = signedHeight < 0;
  header.width = width;
  header.height = header.isTopDown ? 0u - height : height;
  checkImageSize(header.width, header.height);
}

void readMasks(ByteCursor& cursor, BmpHeader& header) {
  header.masks = header.bits == 16 ? std::array<std::uint32_t, 4>{0x7c00, 0x03e0, 0x001f, 0}
                                   : std::array<std::uint32_t, 4>{0xff0000, 0x00ff00, 0x0000ff, 0};
  if (header.compression == kNone) return;
  const bool hasAlpha = header.size >= kHeaderWithAlpha || header.compression == kAlphaBitFields;
  for (std::size_t i = 0; i < (hasAlpha ? 4 : 3); ++i) header.masks[i] = cursor.takeWord();
}

BmpHeader readHeader(ByteView file) {
  ByteCursor cursor(file);
  cursor.take(10);  // "BM", the size, and reserved words
  BmpHeader header;
  header.dataOffset = cursor.takeWord();
  header.size = cursor.takeWord();
  if (header.size == kCoreHeader) {
    const std::uint32_t width = cursor.takeHalf();
    readSides(width, cursor.takeHalf(), header);
    cursor.take(2);  // planes
    header.bits = cursor.takeHalf();
  } else if (header.size >= kInfoHeader && header.size <= kMaxHeader) {
    const std::uint32_t width = cursor.takeWord();
    readSides(width, cursor.takeWord(), header);
    cursor.take(2);
    header.bits = cursor.takeHalf();
    header.compression = cursor.takeWord();
    cursor.take(12);  // the size of the data, and the resolution
    header.colours = cursor.takeWord();
    cursor.take(4);  // important colours
  } else {
    throw FileError(fmt::format("a BMP file with a header of {} bytes, which is unknown", header.size));
  }
  const bool isPlain = header.compression == kNone;
  const bool hasMasks = header.compression == kBitFields || header.compression == kAlphaBitFields;
  if (!isPlain && !hasMasks) throw FileError("a compressed BMP file; only BMP files without compression are read");
  const std::uint32_t b = header.bits;
  const bool isWide = b == 16 || b == 32;
  if (!isWide && (hasMasks || (b != 1 && b != 4 && b != 8 && b != 24))) {
    throw FileError(fmt::format("a BMP file with {} bits per pixel, which is unknown", b));
  }
  if (isWide) readMasks(cursor, header);
  return header;
}

std::uint32_t opaque(ByteView bgr) {
  const auto channel = [&](std::size_t i) { return std::to_integer<std::uint32_t>(bgr[i]); };
  return channel(2) | channel(1) << 8 | channel(0) << 16 | 0xff000000u;
}

/// The colours of the palette; an index without a colour is black.
std::vector<std::uint32_t> paletteOf(ByteView file, const BmpHeader& header) {
  std::vector<std::uint32_t> palette(std::size_t{1} << header.bits, 0xff000000u);
  const std::size_t entry = header.size == kCoreHeader ? 3 : 4;
  const std::size_t stated = header.colours == 0 ? palette.size() : header.colours;
  ByteCursor cursor(file);
  cursor.take(kFileHeader + header.size);
  for (std::size_t i = 0; i < std::min(stated, palette.size()); ++i) palette[i] = opaque(cursor.take(entry));
  return palette;
}

/// A channel of `mask`, stretched to 8 bits; `absent` where the mask is 0.
std::uint32_t channelOf(std::uint32_t pixel, std::uint32_t mask, std::uint32_t absent) {
  if (mask == 0) return absent;
  const int shift = std::countr_zero(mask);
  const std::uint64_t largest = mask >> shift, value = (pixel & mask) >> shift;
  return static_cast<std::uint32_t>((value * 255 + largest / 2) / largest);
}

class RowReader {
 public:
  RowReader(ByteView file, const BmpHeader& header) : header_(header) {
    if (header.bits <= 8) palette_ = paletteOf(file, header);
  }

  std::uint32_t texel(ByteView row, std::uint32_t x) const {
    switch (header_.bits) {
      case 24:
        return opaque(row.subspan(std::size_t{3} * x, 3));
      case 16:
      case 32:
        return masked(row.subspan(std::size_t{x} * header_.bits / 8, header_.bits / 8));
      default:
        return palette_[indexAt(row, x)];
    }
  }

 private:
  std::uint32_t masked(ByteView bytes) const {
    std::uint32_t pixel = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) pixel |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
    const auto channel = [&](std::size_t i) { return channelOf(pixel, header_.masks[i], i == 3 ? 255 : 0); };
    return channel(0) | channel(1) << 8 | channel(2) << 16 | channel(3) << 24;
  }

  /// Pixels of a byte begin with its highest bits.
  std::size_t indexAt(ByteView row, std::uint32_t x) const {
    const std::size_t bit = std::size_t{x} * header_.bits;
    const auto byte = std::to_integer<std::size_t>(row[bit / 8]);
    return byte >> (8 - header_.bits - bit % 8) & ((std::size_t{1} << header_.bits) - 1);
  }

  const BmpHeader& header_;
  std::vector<std::uint32_t> palette_;
};

}  // namespace

Texels decodeBmp(ByteView file) {
  const BmpHeader header = readHeader(file);
  const RowReader reader(file, header);
  const std::size_t stride = (std::size_t{header.width} * header.bits + 31) / 32 * 4;
  ByteCursor cursor(file);
  cursor.take(header.dataOffset);
  const ByteView data = cursor.take(stride * header.height);
  Texels texels{header.width, header.height, {}};
  texels.rgba.reserve(std::size_t{header.width} * header.height);
  for (std::uint32_t y = 0; y < header.height; ++y) {
    const std::size_t stored = header.isTopDown ? y : header.height - 1 - y;
    const ByteView row = data.subspan(stored * stride, stride);
    for (std::uint32_t x = 0; x < header.width; ++x) texels.rgba.push_back(reader.texel(row, x));
  }
  return texels;
}

}  // namespace candela::image
