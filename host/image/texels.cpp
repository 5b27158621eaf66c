// Decodes images of integers.
#include "host/image/texels.h"

#include <algorithm>
#include <string_view>

#include "host/base/errors.h"
#include "host/image/image_format.h"

namespace candela::image {

bool namesSrgb(ByteView profile) {
  const std::string_view text(reinterpret_cast<const char*>(profile.data()), profile.size());
  constexpr std::string_view kWide("s\0R\0G\0B", 7);
  return text.find("sRGB") != std::string_view::npos || text.find(kWide) != std::string_view::npos;
}

Texels decodeTexels(ByteView file) {
  const std::optional<FileFormat> format = formatByContent(file);
  if (!format) throw FileError("not a PNG, JPEG or WebP file");
  switch (*format) {
    case FileFormat::png:
      return decodePng(file);
    case FileFormat::jpeg:
      return decodeJpeg(file);
    case FileFormat::webp:
      return decodeWebp(file);
    case FileFormat::hdr:
      throw FileError("a Radiance HDR file; only PNG, JPEG and WebP files are textures");
    case FileFormat::pfm:
      throw FileError("a PFM file; only PNG, JPEG and WebP files are textures");
    case FileFormat::exr:
      throw FileError("an EXR file; only PNG, JPEG and WebP files are textures");
  }
  throw InternalError("an image format without a decoder");
}

Texels decodeModelTexels(ByteView file) {
  if (formatByContent(file)) return decodeTexels(file);
  const std::string_view start(reinterpret_cast<const char*>(file.data()), std::min<std::size_t>(file.size(), 2));
  if (start == "BM") return decodeBmp(file);
  if (looksLikeTga(file)) return decodeTga(file);
  throw FileError("not a PNG, JPEG, WebP, BMP or TGA file");
}

}  // namespace candela::image
