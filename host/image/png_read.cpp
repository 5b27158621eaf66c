// Reads the stored channels of PNG files with libpng's sequential interface, because the simplified one converts
// colours, in 8 bits or in linear light. Its errors use longjmp, so that no object with a destructor may live between
// setjmp and the jump.
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <iterator>

#include "host/base/errors.h"
#include "host/image/codecs.h"

namespace candela::image {
namespace {

static_assert(std::endian::native == std::endian::little, "channels R G B A are the word of a texel");

constexpr std::uint64_t kEachChannel = 0x0001000100010001;  // 1 in each of four channels of 16 bits

class PngTexelReader {
 public:
  explicit PngTexelReader(ByteView file) : rest_(file) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, leave, ignoreWarning);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_ || !open()) fail();
  }
  PngTexelReader(const PngTexelReader&) = delete;
  PngTexelReader& operator=(const PngTexelReader&) = delete;
  ~PngTexelReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  std::uint32_t width() const { return png_get_image_width(png_, info_); }
  std::uint32_t height() const { return png_get_image_height(png_, info_); }

  bool isDeep() const { return png_get_bit_depth(png_, info_) == 16; }

  /// Returns the exponent of the signal, gAMA; 0 for sRGB, or where the file states nothing.
  double gamma() const {
    double gamma = 0;
    if (png_get_valid(png_, info_, PNG_INFO_sRGB | PNG_INFO_iCCP) != 0) return 0;
    return png_get_gAMA(png_, info_, &gamma) != 0 ? gamma : 0;
  }

  /// Returns the chromaticities of red, green, blue and white; nothing for Rec. 709, or where the file states none.
  std::vector<double> primaries() const {
    std::vector<double> p(8);
    if (png_get_valid(png_, info_, PNG_INFO_sRGB | PNG_INFO_iCCP) != 0) return {};
    const bool isStated = png_get_cHRM(png_, info_, &p[6], &p[7], &p[0], &p[1], &p[2], &p[3], &p[4], &p[5]) != 0;
    return isStated ? p : std::vector<double>{};
  }

  bool hasProfile() const {
    png_charp name = nullptr;
    png_bytep profile = nullptr;
    png_uint_32 size = 0;
    int compression = 0;
    if (png_get_iCCP(png_, info_, &name, &compression, &profile, &size) == 0) return false;
    return !namesSrgb({reinterpret_cast<const std::byte*>(profile), size});
  }

  /// Reads 4 or, if isDeep(), 8 bytes for each pixel.
  void read(void* rgba) {
    if (!decode(static_cast<png_bytep>(rgba))) fail();
  }

 private:
  static void leave(png_structp png, png_const_charp message) {
    auto* const reader = static_cast<PngTexelReader*>(png_get_error_ptr(png));
    std::snprintf(reader->message_, sizeof reader->message_, "%s", message);
    std::longjmp(reader->jump_, 1);
  }
  static void ignoreWarning(png_structp, png_const_charp) {}

  static void take(png_structp png, png_bytep target, std::size_t count) {
    auto* const reader = static_cast<PngTexelReader*>(png_get_io_ptr(png));
    if (count > reader->rest_.size()) png_error(png, "it is truncated");
    std::memcpy(target, reader->rest_.data(), count);
    reader->rest_ = reader->rest_.subspan(count);
  }

  bool open() {
    if (setjmp(jump_)) return false;
    png_set_read_fn(png_, this, take);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // checkImageSize() has our limits
    png_read_info(png_, info_);
    return true;
  }

  bool decode(png_bytep rgba) {
    if (setjmp(jump_)) return false;
    const std::size_t pixelBytes = isDeep() ? 8 : 4;
    png_set_expand(png_);
    png_set_swap(png_);  // files have the more significant byte first
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, isDeep() ? 65535 : 255, PNG_FILLER_AFTER);
    const int passes = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    const std::uint32_t width = this->width();
    const std::uint32_t height = this->height();
    if (png_get_rowbytes(png_, info_) != pixelBytes * width) png_error(png_, "unexpected size of rows");
    for (int pass = 0; pass < passes; ++pass) {
      for (std::uint32_t y = 0; y < height; ++y) {
        png_read_row(png_, rgba + y * pixelBytes * width, nullptr);
      }
    }
    png_read_end(png_, nullptr);
    return true;
  }

  /// Also called from the constructor, whose destructor does not run.
  [[noreturn]] void fail() {
    png_destroy_read_struct(&png_, &info_, nullptr);
    throw FileError(fmt::format("not a valid PNG file: {}", message_));
  }

  ByteView rest_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::jmp_buf jump_;
  char message_[256] = "out of memory";
};

// Returns whether both bytes of each channel are equal, so that the channel is 257 times a value of 8 bits.
bool isShallow(std::uint64_t texel) { return (texel & 255 * kEachChannel) * 257 == texel; }

std::uint32_t shallow(std::uint64_t texel) {
  std::uint32_t bytes = 0;
  for (int c = 0; c < 4; ++c) bytes |= static_cast<std::uint32_t>(texel >> 16 * c & 255u) << 8 * c;
  return bytes;
}

/// Many programs write 16 bits without having more than 8.
Texels withoutNeedlessBits(Texels texels) {
  if (!std::ranges::all_of(texels.deepRgba, isShallow)) return texels;
  texels.rgba.reserve(texels.deepRgba.size());
  std::ranges::transform(texels.deepRgba, std::back_inserter(texels.rgba), shallow);
  texels.deepRgba = {};
  return texels;
}

/// Refuses PNG files that claim more pixels than they can contain. Deflate expands one byte to at most 1032, and a byte
/// has at most 8 pixels.
void checkPlausible(std::uint64_t pixelCount, std::size_t fileSize) {
  constexpr std::uint64_t kMaxPixelsPerByte = 8 * 1032;
  if (pixelCount / kMaxPixelsPerByte > fileSize) throw FileError("not a valid PNG file: it is truncated");
}

}  // namespace

Texels decodePng(ByteView file) {
  PngTexelReader reader(file);
  checkImageSize(reader.width(), reader.height());
  const std::uint64_t pixelCount = std::uint64_t{reader.width()} * reader.height();
  checkPlausible(pixelCount, file.size());
  Texels texels{reader.width(), reader.height(), {}};
  texels.gamma = reader.gamma();
  texels.primaries = reader.primaries();
  texels.hasProfile = reader.hasProfile();
  if (reader.isDeep()) {
    texels.deepRgba.resize(pixelCount);
    reader.read(texels.deepRgba.data());
    return withoutNeedlessBits(std::move(texels));
  }
  texels.rgba.resize(pixelCount);
  reader.read(texels.rgba.data());
  return texels;
}

}  // namespace candela::image
