// Decodes images of integers.
#include "host/image/texels.h"

#include "host/core/errors.h"
#include "host/image/image_format.h"

namespace candela::image {

Texels decodeTexels(ByteView file) {
  switch (formatByContent(file)) {
    case FileFormat::png:
      return decodePng(file);
    case FileFormat::jpeg:
      return decodeJpeg(file);
    case FileFormat::webp:
      return decodeWebp(file);
    default:
      throw FileError("not a PNG, JPEG or WebP file");
  }
}

}  // namespace candela::image
