// Reads WebP files with libwebp.
#include <webp/decode.h>

#include <algorithm>
#include <bit>
#include <string_view>

#include "host/base/errors.h"
#include "host/image/codecs.h"

namespace candela::image {

static_assert(std::endian::native == std::endian::little, "bytes R G B A are the word of a texel");

namespace {

/// Returns whether the file has an ICC profile that does not name sRGB. It is the first chunk after the header VP8X.
bool hasProfile(ByteView file) {
  constexpr std::size_t kHeader = 30, kChunkHeader = 8;
  if (file.size() < kHeader + kChunkHeader) return false;
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  if (text.substr(12, 4) != "VP8X" || text.substr(kHeader, 4) != "ICCP") return false;
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) size |= std::to_integer<std::size_t>(file[kHeader + 4 + i]) << 8 * i;
  const ByteView rest = file.subspan(kHeader + kChunkHeader);
  return !namesSrgb(rest.first(std::min(size, rest.size())));
}

}  // namespace

Texels decodeWebp(ByteView file) {
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(file.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes, file.size(), &features) != VP8_STATUS_OK) throw FileError("not a valid WebP file");
  if (features.has_animation != 0) throw FileError("an animated WebP file; only still images are read");
  checkImageSize(static_cast<std::uint64_t>(features.width), static_cast<std::uint64_t>(features.height));
  Texels texels{static_cast<std::uint32_t>(features.width), static_cast<std::uint32_t>(features.height), {}};
  texels.hasProfile = hasProfile(file);
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
