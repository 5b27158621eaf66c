// Reads JPEG files with libjpeg. Its errors use longjmp, so that no object with a destructor may live between setjmp
// and the jump.
#include <fmt/format.h>
#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <cstdio>
#include <cstdlib>

#include "host/base/errors.h"
#include "host/image/codecs.h"

namespace candela::image {
namespace {

/// Maximum number of scans. A progressive file may repeat scans, each of which costs a pass over the whole image.
constexpr int kMaxScans = 500;

struct ErrorHandler {
  jpeg_error_mgr base;  // first member, so that a pointer to it is a pointer to this object
  std::jmp_buf jump;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void leave(j_common_ptr info) {
  auto* handler = reinterpret_cast<ErrorHandler*>(info->err);
  info->err->format_message(info, handler->message);
  std::longjmp(handler->jump, 1);
}

/// Turns warnings into errors. Damaged data are only a warning to libjpeg, which would continue with grey pixels.
void refuseDamage(j_common_ptr info, int level) {
  const int code = info->err->msg_code;
  const bool harmless = code == JWRN_EXTRANEOUS_DATA || code == JWRN_JFIF_MAJOR || code == JWRN_ADOBE_XFORM ||
                        code == JWRN_BOGUS_ICC;
  if (level < 0 && !harmless) leave(info);
}

void limitScans(j_common_ptr info) {
  const auto* decompressor = reinterpret_cast<const jpeg_decompress_struct*>(info);
  if (decompressor->input_scan_number <= kMaxScans) return;
  auto* handler = reinterpret_cast<ErrorHandler*>(info->err);
  std::snprintf(handler->message, sizeof handler->message, "more than %d scans", kMaxScans);
  std::longjmp(handler->jump, 1);
}

class JpegReader {
 public:
  explicit JpegReader(ByteView file) {
    info_.err = jpeg_std_error(&errors_.base);
    errors_.base.error_exit = leave;
    errors_.base.emit_message = refuseDamage;
    if (!open(file)) fail();
  }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
  ~JpegReader() { jpeg_destroy_decompress(&info_); }

  std::uint32_t width() const { return info_.image_width; }
  std::uint32_t height() const { return info_.image_height; }

  /// Returns whether there is an ICC profile that does not name sRGB.
  bool hasProfile() {
    if (setjmp(errors_.jump)) fail();
    JOCTET* profile = nullptr;
    unsigned int size = 0;
    if (!jpeg_read_icc_profile(&info_, &profile, &size)) return false;
    const bool isOther = !namesSrgb({reinterpret_cast<const std::byte*>(profile), size});
    std::free(profile);
    return isOther;
  }

  void readRgb(std::uint8_t* rgb) {
    if (!decode(rgb)) fail();
  }

 private:
  bool open(ByteView file) {
    if (setjmp(errors_.jump)) {
      jpeg_destroy_decompress(&info_);  // the destructor does not run where the constructor fails
      return false;
    }
    jpeg_create_decompress(&info_);
    progress_.progress_monitor = limitScans;
    info_.progress = &progress_;
    jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(file.data()), file.size());
    jpeg_save_markers(&info_, JPEG_APP0 + 2, 0xffff);  // ICC profiles
    jpeg_read_header(&info_, TRUE);
    return true;
  }

  bool decode(std::uint8_t* rgb) {
    if (setjmp(errors_.jump)) return false;
    info_.out_color_space = JCS_RGB;
    jpeg_start_decompress(&info_);
    while (info_.output_scanline < info_.output_height) {
      JSAMPROW row = rgb + std::size_t{3} * info_.output_width * info_.output_scanline;
      jpeg_read_scanlines(&info_, &row, 1);
    }
    jpeg_finish_decompress(&info_);
    return true;
  }

  [[noreturn]] void fail() const { throw FileError(fmt::format("not a valid JPEG file: {}", errors_.message)); }

  jpeg_decompress_struct info_{};
  ErrorHandler errors_{};
  jpeg_progress_mgr progress_{};
};

/// Refuses files that claim more pixels than they can contain. Each block of 8x8 pixels takes at least one bit in the
/// Huffman codes of its first coefficient; arithmetic codes are allowed a factor of eight.
void requirePlausible(std::uint64_t pixelCount, std::size_t fileSize) {
  constexpr std::uint64_t kMaxPixelsPerByte = 8 * 8 * 64;
  if (pixelCount / kMaxPixelsPerByte > fileSize) throw FileError("not a valid JPEG file: it is truncated");
}

}  // namespace

Texels decodeJpeg(ByteView file) {
  JpegReader reader(file);
  checkImageSize(reader.width(), reader.height());
  requirePlausible(std::uint64_t{reader.width()} * reader.height(), file.size());
  const std::size_t pixelCount = std::size_t{reader.width()} * reader.height();
  std::vector<std::uint8_t> rgb(3 * pixelCount);
  const bool hasProfile = reader.hasProfile();
  reader.readRgb(rgb.data());
  constexpr std::uint32_t kOpaque = 255u << 24;
  Texels texels{reader.width(), reader.height(), std::vector<std::uint32_t>(pixelCount)};
  for (std::size_t i = 0; i < pixelCount; ++i) {
    const std::uint8_t* const pixel = &rgb[3 * i];
    texels.rgba[i] = pixel[0] | std::uint32_t{pixel[1]} << 8 | std::uint32_t{pixel[2]} << 16 | kOpaque;
  }
  texels.hasProfile = hasProfile;
  return texels;
}

}  // namespace candela::image
