// The lengths of attribute types ("OpenEXR File Layout", openexr.com).
#include "host/image/exr_attribute.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <utility>

#include "host/base/errors.h"
#include "host/image/byte_cursor.h"
#include "host/image/image.h"

namespace candela::image {
namespace {

constexpr std::array<std::pair<std::string_view, std::size_t>, 24> kFixedSizes{{
    {"box2i", 16},
    {"box2f", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
}};

std::uint64_t wordAt(ByteView bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
  return word;
}

// Width and height, then four bytes per pixel.
std::uint64_t previewSize(ByteView value) {
  if (value.size() < 8) return 8;
  const std::uint64_t width = wordAt(value, 0), height = wordAt(value, 4);
  return width > kMaxImageSide || height > kMaxImageSide ? 0 : 8 + 4 * width * height;
}

// Names, each with 16 bytes, and an empty name.
std::uint64_t channelListSize(ByteView value) {
  constexpr std::size_t kChannelBytes = 16;
  ByteCursor cursor(value);
  while (!cursor.takeUntil([](char c) { return c == 0; }).empty()) cursor.take(kChannelBytes);
  return value.size() - cursor.remaining();
}

std::uint64_t sizeOf(std::string_view type, ByteView value) {
  if (type == "chlist") return channelListSize(value);
  if (type == "preview") return previewSize(value);
  for (const auto& [name, size] : kFixedSizes) {
    if (name == type) return size;
  }
  return value.size();
}

}  // namespace

void requireExrAttribute(std::string_view type, ByteView value) {
  if (sizeOf(type, value) == value.size()) return;
  throw FileError(fmt::format("not a valid EXR file: an attribute of type \"{}\" has {} bytes", type, value.size()));
}

}  // namespace candela::image
