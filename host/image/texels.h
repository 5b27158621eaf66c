// Images of textures: four channels as the file stores them, without conversion of colours.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela::image {

/// 8-bit RGBA, row by row from the top.
struct Texels {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint32_t> rgba;  ///< red | green << 8 | blue << 16 | alpha << 24
};

/// Decodes a PNG, JPEG or WebP file, distinguished by its first bytes. Grey becomes equal channels, palettes are
/// resolved, 16 bits are rounded to 8, and alpha is 255 where the file has none. What the file states about its colour
/// space is ignored, as glTF 2.0 requires (section 3.8.3). Accepts any bytes; throws FileError if they are not such a
/// file, or one beyond the limits of checkImageSize().
Texels decodeTexels(std::span<const std::byte> file);

}  // namespace candela::image
