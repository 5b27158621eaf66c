// Reads PNG files with libpng's simplified interface, which converts every kind of PNG and needs no setjmp here.
#include <fmt/format.h>
#include <png.h>

#include "host/core/errors.h"
#include "host/image/codecs.h"

namespace candela::image {
namespace {

class PngReader {
 public:
  explicit PngReader(ByteView file) {
    image_.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&image_, file.data(), file.size())) fail();
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_image_free(&image_); }

  std::uint32_t width() const { return image_.width; }
  std::uint32_t height() const { return image_.height; }

  void readRgb(std::uint8_t* rgb) {
    image_.format = PNG_FORMAT_RGB;
    image_.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // otherwise 16-bit files without a gamma are taken as linear
    const png_color black{0, 0, 0};
    constexpr png_int_32 kPackedRows = 0;
    if (!png_image_finish_read(&image_, &black, rgb, kPackedRows, nullptr)) fail();
  }

 private:
  /// Throws from the constructor, whose destructor does not run; libpng has freed its memory by then.
  [[noreturn]] void fail() const { throw FileError(fmt::format("not a valid PNG file: {}", image_.message)); }

  png_image image_{};
};

}  // namespace

// Deflate expands one byte to at most 1032, and a byte has at most 8 pixels.
void checkPngPlausible(std::uint64_t pixelCount, std::size_t fileSize) {
  constexpr std::uint64_t kMaxPixelsPerByte = 8 * 1032;
  if (pixelCount / kMaxPixelsPerByte > fileSize) throw FileError("not a valid PNG file: it is truncated");
}

Pixels8 decodePng(ByteView file) {
  PngReader reader(file);
  checkImageSize(reader.width(), reader.height());
  const std::uint64_t pixelCount = std::uint64_t{reader.width()} * reader.height();
  checkPngPlausible(pixelCount, file.size());
  Pixels8 pixels{reader.width(), reader.height(), std::vector<std::uint8_t>(3 * pixelCount)};
  reader.readRgb(pixels.rgb.data());
  return pixels;
}

}  // namespace candela::image
