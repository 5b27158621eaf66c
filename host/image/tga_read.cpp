// Reads Truevision TGA files, which old models have as textures (TGA File Format Specification, version 2.0, 1991).
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "host/base/errors.h"
#include "host/image/byte_cursor.h"

namespace candela::image {
namespace {

constexpr std::size_t kHeaderSize = 18;
enum ImageType : std::uint8_t { kPalette = 1, kColour = 2, kGrey = 3, kRunLengths = 8 };  // the last one is a flag

struct TgaHeader {
  std::uint8_t idLength = 0, paletteKind = 0, type = 0;
  std::uint32_t firstColour = 0, colours = 0;
  std::uint8_t colourBits = 0;
  std::uint32_t width = 0, height = 0;
  std::uint8_t bits = 0, descriptor = 0;

  bool hasRunLengths() const { return (type & kRunLengths) != 0; }
  std::uint8_t kind() const { return type & static_cast<std::uint8_t>(~kRunLengths); }
  bool hasAlpha() const { return (descriptor & 15) != 0; }
  bool isTopDown() const { return (descriptor & 32) != 0; }
  bool isMirrored() const { return (descriptor & 16) != 0; }
  std::size_t pixelSize() const { return (bits + 7u) / 8u; }
};

bool isColourSize(unsigned bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

/// Reads the header of any 18 bytes.
TgaHeader readHeader(ByteCursor& cursor) {
  TgaHeader h;
  h.idLength = cursor.takeByte();
  h.paletteKind = cursor.takeByte();
  h.type = cursor.takeByte();
  h.firstColour = cursor.takeHalf();
  h.colours = cursor.takeHalf();
  h.colourBits = cursor.takeByte();
  cursor.take(4);  // where the image is on a screen
  h.width = cursor.takeHalf();
  h.height = cursor.takeHalf();
  h.bits = cursor.takeByte();
  h.descriptor = cursor.takeByte();
  return h;
}

bool isPlausible(const TgaHeader& h) {
  if (h.paletteKind > 1 || h.width == 0 || h.height == 0 || h.type > (kGrey | kRunLengths)) return false;
  if (h.kind() == kPalette) return h.paletteKind == 1 && h.bits == 8 && h.colours > 0 && isColourSize(h.colourBits);
  if (h.kind() == kGrey) return h.bits == 8;
  return h.kind() == kColour && isColourSize(h.bits);
}

/// A colour of 15, 16, 24 or 32 bits, whose bytes are in the order blue, green, red, alpha.
std::uint32_t colourOf(ByteView bytes, bool hasAlpha) {
  const auto byte = [&](std::size_t i) { return std::to_integer<std::uint32_t>(bytes[i]); };
  if (bytes.size() == 2) {
    const std::uint32_t word = byte(0) | byte(1) << 8;
    const auto channel = [&](int shift) { return ((word >> shift & 31) * 255 + 15) / 31; };
    const std::uint32_t alpha = hasAlpha && word >> 15 == 0 ? 0 : 255;
    return channel(10) | channel(5) << 8 | channel(0) << 16 | alpha << 24;
  }
  const std::uint32_t alpha = bytes.size() == 4 && hasAlpha ? byte(3) : 255;
  return byte(2) | byte(1) << 8 | byte(0) << 16 | alpha << 24;
}

class PixelReader {
 public:
  PixelReader(const TgaHeader& header, ByteCursor& cursor) : header_(header), cursor_(cursor) {
    if (header.paletteKind == 0) return;
    const std::size_t entry = (header.colourBits + 7u) / 8u;
    const ByteView colours = cursor.take(entry * header.colours);
    if (header.kind() != kPalette) return;
    for (std::size_t i = 0; i < header.colours; ++i) {
      palette_.push_back(colourOf(colours.subspan(i * entry, entry), header.colourBits == 32));
    }
  }

  std::uint32_t next() {
    const ByteView bytes = cursor_.take(header_.pixelSize());
    const auto value = std::to_integer<std::uint32_t>(bytes[0]);
    if (header_.kind() == kGrey) return value * 0x010101u | 0xff000000u;
    if (header_.kind() == kColour) return colourOf(bytes, header_.hasAlpha());
    if (value < header_.firstColour || value - header_.firstColour >= palette_.size()) {
      throw FileError(fmt::format("a TGA file whose palette has no colour {}", value));
    }
    return palette_[value - header_.firstColour];
  }

 private:
  const TgaHeader& header_;
  ByteCursor& cursor_;
  std::vector<std::uint32_t> palette_;
};

/// Packets of up to 128 pixels: one value that is repeated, or as many values.
void readRuns(PixelReader& reader, ByteCursor& cursor, std::vector<std::uint32_t>& pixels, std::size_t count) {
  while (pixels.size() < count) {
    const std::uint8_t packet = cursor.takeByte();
    const std::size_t length = std::min<std::size_t>((packet & 127u) + 1u, count - pixels.size());
    if ((packet & 128u) != 0) {
      pixels.insert(pixels.end(), length, reader.next());
    } else {
      for (std::size_t i = 0; i < length; ++i) pixels.push_back(reader.next());
    }
  }
}

void flipRows(std::vector<std::uint32_t>& pixels, std::size_t width) {
  const std::span all(pixels);
  for (std::size_t top = 0, bottom = all.size() - width; top < bottom; top += width, bottom -= width) {
    std::ranges::swap_ranges(all.subspan(top, width), all.subspan(bottom, width));
  }
}

void mirrorRows(std::vector<std::uint32_t>& pixels, std::size_t width) {
  for (std::size_t i = 0; i < pixels.size(); i += width) {
    std::ranges::reverse(std::span(pixels).subspan(i, width));
  }
}

}  // namespace

bool looksLikeTga(ByteView file) {
  if (file.size() <= kHeaderSize) return false;
  ByteCursor cursor(file);
  return isPlausible(readHeader(cursor));
}

Texels decodeTga(ByteView file) {
  ByteCursor cursor(file);
  const TgaHeader header = readHeader(cursor);
  if (!isPlausible(header)) throw FileError("not a valid TGA file");
  checkImageSize(header.width, header.height);
  cursor.take(header.idLength);
  PixelReader reader(header, cursor);
  const std::size_t count = std::size_t{header.width} * header.height;
  // Before memory is allocated: a packet has at least one pixel for 128.
  const std::size_t least = header.hasRunLengths() ? (count + 127) / 128 * (1 + header.pixelSize())
                                                   : count * header.pixelSize();
  if (cursor.remaining() < least) throw FileError("the file is truncated");
  Texels texels{header.width, header.height, {}};
  std::vector<std::uint32_t>& pixels = texels.rgba;
  pixels.reserve(count);
  if (header.hasRunLengths()) readRuns(reader, cursor, pixels, count);
  while (pixels.size() < count) pixels.push_back(reader.next());
  if (!header.isTopDown()) flipRows(pixels, header.width);
  if (header.isMirrored()) mirrorRows(pixels, header.width);
  return texels;
}

}  // namespace candela::image
