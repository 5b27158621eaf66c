// Chooses the decoder of a texture's image.
#include "host/image/texels.h"

#include <algorithm>
#include <string_view>

#include "host/core/errors.h"
#include "host/image/codecs.h"

namespace candela::image {
namespace {

constexpr std::uint32_t kOpaque = 255u << 24;

Texels withAlpha(const Pixels8& pixels) {
  Texels texels{pixels.width, pixels.height, std::vector<std::uint32_t>(pixels.rgb.size() / 3)};
  for (std::size_t i = 0; i < texels.rgba.size(); ++i) {
    const std::uint8_t* const rgb = &pixels.rgb[3 * i];
    texels.rgba[i] = rgb[0] | std::uint32_t{rgb[1]} << 8 | std::uint32_t{rgb[2]} << 16 | kOpaque;
  }
  return texels;
}

}  // namespace

Texels decodeTexels(ByteView file) {
  const std::string_view start(reinterpret_cast<const char*>(file.data()), std::min<std::size_t>(file.size(), 12));
  if (start.starts_with("\x89PNG")) return decodePngTexels(file);
  if (start.starts_with("\xff\xd8")) return withAlpha(decodeJpeg(file));
  if (start.starts_with("RIFF") && start.ends_with("WEBP")) return decodeWebp(file);
  throw FileError("not a PNG, JPEG or WebP file");
}

}  // namespace candela::image
