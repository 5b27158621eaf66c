// Converts films to images, and chooses the format of image files.
#include "host/image/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <numeric>

#include "host/core/atomic_file.h"
#include "host/core/errors.h"
#include "host/core/file_extension.h"
#include "host/image/codecs.h"
#include "host/image/colour_transfer.h"

namespace candela::image {
namespace {

namespace fs = std::filesystem;

enum class Format { png, jpeg, hdr, pfm, exr };

std::optional<Format> formatByExtension(const fs::path& file) {
  const std::string extension = extensionOf(file);
  if (extension == ".png") return Format::png;
  if (extension == ".jpg" || extension == ".jpeg") return Format::jpeg;
  if (extension == ".hdr") return Format::hdr;
  if (extension == ".pfm") return Format::pfm;
  if (extension == ".exr") return Format::exr;
  return std::nullopt;
}

Format formatByContent(ByteView bytes) {
  const std::string_view start(reinterpret_cast<const char*>(bytes.data()), std::min<std::size_t>(bytes.size(), 4));
  if (start.starts_with("\x89PNG")) return Format::png;
  if (start.starts_with("\xff\xd8")) return Format::jpeg;
  if (start.starts_with("#?")) return Format::hdr;
  if (start.starts_with("PF") || start.starts_with("Pf")) return Format::pfm;
  if (start.starts_with("\x76\x2f\x31\x01")) return Format::exr;
  throw FileError("not a PNG, JPEG, HDR, PFM or EXR file");
}

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

/// Decodes a file. Adds its name to the message of an error.
template <typename Decode>
auto decodeFile(const fs::path& file, Decode decode) {
  const Bytes bytes = readFile(file);
  try {
    return decode(ByteView(bytes), formatByContent(bytes));
  } catch (const FileError& error) {
    failReading(file, error.what());
  }
}

Pixels8 decodePixels8(ByteView bytes, Format format) {
  switch (format) {
    case Format::png:
      return decodePng(bytes);
    case Format::jpeg:
      return decodeJpeg(bytes);
    default:
      throw FileError("not a PNG or JPEG file");
  }
}

Image decodeImage(ByteView bytes, Format format) {
  switch (format) {
    case Format::hdr:
      return decodeHdr(bytes);
    case Format::pfm:
      return decodePfm(bytes);
    case Format::exr:
      return decodeExr(bytes);
    default:
      return toImage(decodePixels8(bytes, format));
  }
}

Bytes encodeImage(Format format, const Image& image, const DisplayTransform& transform) {
  switch (format) {
    case Format::png:
      return encodePng(image.alpha.empty() ? toPixels8(image, transform) : toStraightPixels8(image, transform));
    case Format::jpeg:
      return encodeJpeg(toPixels8(image, transform));
    case Format::hdr:
      return encodeHdr(image);
    case Format::pfm:
      return encodePfm(image);
    case Format::exr:
      return encodeExr(image);
  }
  throw InternalError("an image format without an encoder");
}

Format requireFormat(const fs::path& file) {
  const std::optional<Format> format = formatByExtension(file);
  if (format) return *format;
  throw UsageError(fmt::format("\"{}\": the name of an image file must end in .png, .jpg, .jpeg, .hdr, .pfm or .exr",
                               file.string()));
}

}  // namespace

void checkImageSize(std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0) throw FileError("the image has no pixels");
  if (width > kMaxImageSide || height > kMaxImageSide || width * height > kMaxImagePixels) {
    throw FileError(fmt::format("{} x {} pixels exceed the limits of {} per side and {} in total", width, height,
                                kMaxImageSide, kMaxImagePixels));
  }
}

Image toImage(const Film& film) {
  Image image;
  image.width = film.width();
  image.height = film.height();
  image.rgb.reserve(film.pixels().size());
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      image.rgb.emplace_back(film.mean(x, y));
      image.luminanceVariance.push_back(static_cast<float>(film.luminanceVariance(x, y)));
      image.sampleCounts.push_back(film.at(x, y).sampleCount);
      image.badSampleCounts.push_back(film.at(x, y).badCount);
    }
  }
  const std::uint64_t badCount = badSampleCount(image);
  if (badCount > 0) {
    image.metadata["candela.badSamples"] = std::to_string(badCount);
  } else {
    image.badSampleCounts.clear();
  }
  return image;
}

std::uint64_t badSampleCount(const Image& image) {
  return std::accumulate(image.badSampleCounts.begin(), image.badSampleCounts.end(), std::uint64_t{0});
}

void addAlpha(Image& image, const Film& film) {
  image.alpha.reserve(film.pixels().size());
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) image.alpha.push_back(static_cast<float>(film.alpha(x, y)));
  }
}

Pixels8 toStraightPixels8(const Image& image, const DisplayTransform& transform) {
  Image straight{image.width, image.height, image.rgb, {}, {}, {}, {}};
  std::vector<std::uint8_t> alpha;
  alpha.reserve(image.alpha.size());
  for (std::size_t i = 0; i < image.alpha.size(); ++i) {
    const float opacity = image.alpha[i] > 0 ? std::min(image.alpha[i], 1.0f) : 0;  // also where it is not a number
    straight.rgb[i] = opacity > 0 ? image.rgb[i] / opacity : glm::vec3(0);
    alpha.push_back(static_cast<std::uint8_t>(std::lround(255 * opacity)));
  }
  Pixels8 pixels = toPixels8(straight, transform);
  pixels.alpha = std::move(alpha);
  return pixels;
}

Pixels8 toPixels8(const Image& image, const DisplayTransform& transform) {
  Pixels8 pixels{image.width, image.height, {}};
  pixels.rgb.reserve(3 * image.rgb.size());
  for (const glm::vec3& linear : image.rgb) {
    const glm::u8vec3 pixel = toDisplay(linear, transform);
    pixels.rgb.insert(pixels.rgb.end(), {pixel.x, pixel.y, pixel.z});
  }
  return pixels;
}

std::vector<std::byte> toPng(const Pixels8& pixels) {
  checkImageSize(pixels.width, pixels.height);
  return encodePng(pixels);
}

Image toImage(const Pixels8& pixels) {
  std::array<float, 256> linear;
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = static_cast<float>(srgbDecode(static_cast<double>(i) / 255));
  Image image{pixels.width, pixels.height, {}, {}, {}, {}, {}};
  image.rgb.reserve(pixels.rgb.size() / 3);
  for (std::size_t i = 0; i + 2 < pixels.rgb.size(); i += 3) {
    image.rgb.emplace_back(linear[pixels.rgb[i]], linear[pixels.rgb[i + 1]], linear[pixels.rgb[i + 2]]);
  }
  return image;
}

bool hasImageExtension(const fs::path& file) { return formatByExtension(file).has_value(); }

void checkImageFormat(const fs::path& file) { requireFormat(file); }

bool isEightBit(const fs::path& file) {
  const Format format = requireFormat(file);
  return format == Format::png || format == Format::jpeg;
}

bool isExr(const fs::path& file) { return requireFormat(file) == Format::exr; }

void writeImage(const fs::path& file, const Image& image, const DisplayTransform& transform) {
  const Format format = requireFormat(file);
  Bytes bytes;
  try {
    checkImageSize(image.width, image.height);
    bytes = encodeImage(format, image, transform);
  } catch (const FileError& error) {
    throw FileError(fmt::format("cannot write \"{}\": {}", file.string(), error.what()));
  }
  writeFileAtomically(file, bytes);
}

Image readImage(const fs::path& file) { return decodeFile(file, decodeImage); }

Pixels8 readPixels8(const fs::path& file) { return decodeFile(file, decodePixels8); }

}  // namespace candela::image
