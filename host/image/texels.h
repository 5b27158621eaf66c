// Images of integers, such as textures: four channels as the file stores them, without conversion of colours.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela::image {

/// RGBA of 8 or 16 bits per channel, row by row from the top. One of the two arrays is empty.
struct Texels {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint32_t> rgba;           ///< red | green << 8 | blue << 16 | alpha << 24
  std::vector<std::uint64_t> deepRgba = {};  ///< red | green << 16 | blue << 32 | alpha << 48
  double gamma = 0;                          ///< that a PNG states (its gAMA chunk); 0: that of sRGB
  std::vector<double> primaries{};  ///< x and y of red, green, blue and white that a PNG states (cHRM); empty: Rec. 709
  bool hasProfile = false;          ///< whether the file has an ICC profile that does not name sRGB
};

/// Decodes a PNG, JPEG or WebP file, distinguished by its first bytes. Grey becomes equal channels, palettes are
/// resolved, and alpha is the largest value where the file has none. PNG files of 16 bits keep them, unless all values
/// are 257 times one of 8 bits, which means the same. What the file states about its colour space is ignored, as
/// glTF 2.0 requires (section 3.8.3), and so are the members for it there. Accepts any bytes; throws FileError if they
/// are not such a file, or one beyond the limits of checkImageSize().
Texels decodeTexels(std::span<const std::byte> file);

/// Decodes such a file, or a BMP or TGA file, which models in OBJ and PLY have: BMP without compression, and all kinds
/// of TGA of 8 bits per channel or fewer.
Texels decodeModelTexels(std::span<const std::byte> file);

}  // namespace candela::image
