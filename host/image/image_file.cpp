// Reads and writes image files.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "host/base/atomic_file.h"
#include "host/base/errors.h"
#include "host/base/standard_output.h"
#include "host/image/codecs.h"
#include "host/image/image.h"
#include "host/image/image_format.h"

namespace candela::image {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failReading(const fs::path& file, const std::string& cause) {
  throw FileError(fmt::format("cannot read \"{}\": {}", file.string(), cause));
}

Bytes readFile(const fs::path& file) {
  constexpr std::uintmax_t kMaxSize = 24 * kMaxImagePixels;  // all channels of the largest EXR, uncompressed
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) failReading(file, error.message());
  if (size > kMaxSize) failReading(file, "the file is too large for an image");
  Bytes bytes(size);
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!stream) failReading(file, "no permission, or the file changed while it was read");
  return bytes;
}

Image decodeImage(ByteView bytes, ImageParts parts) {
  const std::optional<FileFormat> format = formatByContent(bytes);
  if (!format) throw FileError("not a PNG, JPEG, WebP, HDR, PFM or EXR file");
  switch (*format) {
    case FileFormat::hdr:
      return decodeHdr(bytes);
    case FileFormat::pfm:
      return decodePfm(bytes);
    case FileFormat::exr:
      return decodeExr(bytes, parts);
    default:
      return toImage(decodeTexels(bytes));
  }
}

Bytes encodeImage(FileFormat format, const Image& image, const DisplayTransform& transform) {
  switch (format) {
    case FileFormat::png:
      return encodePng(image.alpha.empty() ? toPixels8(image, transform) : toStraightPixels8(image, transform));
    case FileFormat::jpeg:
      return encodeJpeg(toPixels8(image, transform));
    case FileFormat::hdr:
      return encodeHdr(image);
    case FileFormat::pfm:
      return encodePfm(image);
    case FileFormat::exr:
      return encodeExr(image);
    case FileFormat::webp:
      break;
  }
  throw InternalError("an image format without an encoder");
}

}  // namespace

void writeImage(const fs::path& file, const Image& image, const DisplayTransform& transform) {
  const FileFormat format = requireFormat(file);
  Bytes bytes;
  try {
    checkImageSize(image.width, image.height);
    bytes = encodeImage(format, image, transform);
  } catch (const FileError& error) {
    throw FileError(fmt::format("cannot write \"{}\": {}", file.string(), error.what()));
  }
  if (isStandardOutput(file)) {
    writeStandardOutput(bytes);
  } else {
    writeFileAtomically(file, bytes);
  }
}

Image readImage(const fs::path& file, ImageParts parts) {
  const Bytes bytes = readFile(file);
  try {
    return decodeImage(bytes, parts);
  } catch (const FileError& error) {
    failReading(file, error.what());
  }
}

}  // namespace candela::image
