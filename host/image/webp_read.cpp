// Reads WebP files with libwebp.
#include <webp/decode.h>

#include <bit>

#include "host/core/errors.h"
#include "host/image/codecs.h"

namespace candela::image {

static_assert(std::endian::native == std::endian::little, "bytes R G B A are the word of a texel");

Texels decodeWebp(ByteView file) {
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(file.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes, file.size(), &features) != VP8_STATUS_OK) throw FileError("not a valid WebP file");
  if (features.has_animation != 0) throw FileError("an animated WebP file; only still images are read");
  checkImageSize(static_cast<std::uint64_t>(features.width), static_cast<std::uint64_t>(features.height));
  Texels texels{static_cast<std::uint32_t>(features.width), static_cast<std::uint32_t>(features.height), {}};
  texels.rgba.resize(std::size_t{texels.width} * texels.height);
  const std::size_t byteCount = 4 * texels.rgba.size();
  const int stride = 4 * features.width;
  auto* const target = reinterpret_cast<std::uint8_t*>(texels.rgba.data());
  if (WebPDecodeRGBAInto(bytes, file.size(), target, byteCount, stride) == nullptr) {
    throw FileError("not a valid WebP file: it is damaged or truncated");
  }
  return texels;
}

}  // namespace candela::image
