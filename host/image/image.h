// Images in memory and their files.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/image/film.h"

namespace candela::image {

/// Linear RGB, row by row from the top. The other three (variance of the luminance of one sample, numbers of samples,
/// and how many of them were bad) have one entry per pixel, or none where the file did not carry them.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<glm::vec3> rgb;
  std::vector<float> luminanceVariance;
  std::vector<std::uint32_t> sampleCounts;
  std::vector<std::uint32_t> badSampleCounts;  ///< FilmPixel::badCount
  std::map<std::string, std::string> metadata;

  glm::vec3& at(std::uint32_t x, std::uint32_t y) { return rgb[std::size_t{y} * width + x]; }
  const glm::vec3& at(std::uint32_t x, std::uint32_t y) const { return rgb[std::size_t{y} * width + x]; }
};

/// The film's means, rounded once to binary32, with variance and counts. Only if samples were bad, the image has their
/// counts, and the metadata entry "candela.badSamples" says how many there are.
Image toImage(const Film& film);
/// The sum of `badSampleCounts`.
std::uint64_t badSampleCount(const Image& image);

enum class ToneMap { none, srgb, aces, agx, neutral, depth, heat };

/// How linear RGB becomes 8-bit pixels: radiance * 2^exposure, then the curve, then (all but `none`) the sRGB transfer
/// function, then round(255 x). `none` clips the linear value and applies no transfer function. NaN and negative
/// values show as black. The curves: `aces` Narkowicz' fit (2016), `agx` Wrensch's polynomial (2023), `neutral` Khronos
/// PBR Neutral (2024), `srgb` none at all. `depth` and `heat` are false colours, signals as they stand: of
/// v = red channel * 2^exposure / scale, `depth` shows the grey 1 / (1 + v^2), but black where v is 0, which means that
/// nothing was hit; `heat` shows magma(v) (host/image/colour_map.h).
struct DisplayTransform {
  ToneMap toneMap = ToneMap::srgb;
  float exposure = 0;  ///< stops
  float scale = 1;     ///< of false colours, > 0
};
glm::u8vec3 toDisplay(const glm::vec3& linear, const DisplayTransform& transform);

/// Largest images that are read or written.
inline constexpr std::uint32_t kMaximumImageSide = 65535;
inline constexpr std::uint64_t kMaximumImagePixels = std::uint64_t{1} << 28;

/// 8-bit RGB pixels, 3 bytes each, row by row from the top.
struct Pixels8 {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgb;
};
Pixels8 toPixels8(const Image& image, const DisplayTransform& transform);
/// The bytes of a PNG file. Throws FileError for an image without pixels or beyond the limits above.
std::vector<std::byte> toPng(const Pixels8& pixels);
/// Decodes sRGB.
Image toImage(const Pixels8& pixels);

/// Formats, by extension in any case: .png (8 bit, display transform), .jpg and .jpeg (quality 95), .hdr (Radiance
/// RGBE, negative values become 0), .pfm (binary32, little-endian), .exr (binary32 linear Rec. 709, ZIP; channels R G
/// B, `variance.Y`, `samples`, `badSamples` as far as the image has them, and the metadata as string attributes).
/// Throws UsageError for an extension that is not one of them.
void checkImageFormat(const std::filesystem::path& file);
/// Whether such a file holds 8-bit pixels, made by a display transform. Throws as checkImageFormat does.
bool isEightBit(const std::filesystem::path& file);
/// Writes beside, syncs, renames: an error leaves no half-written file. Equal images give equal bytes. Throws
/// UsageError for the extension; FileError if the image is empty or too large, for metadata names that EXR reserves,
/// or if the file cannot be written.
void writeImage(const std::filesystem::path& file, const Image& image, const DisplayTransform& transform);
/// Reads PNG and JPEG (decoded from sRGB), HDR, PFM and EXR, told apart by their first bytes. Of an EXR file the data
/// window of the first part is read: R, G and B, or Y alone as grey, `variance.Y`, `samples`, `badSamples` and string
/// attributes.
/// HDR pixels are divided by the file's EXPOSURE; the size of PFM's scale is ignored, only its sign counts.
/// Hostile files give a FileError, never a crash.
Image readImage(const std::filesystem::path& file);
/// The pixels of a PNG or JPEG file as stored. Grey becomes equal channels, palettes are looked up, 16 bits are rounded
/// to 8, transparent pixels are composed on black, a PNG that states another gamma than sRGB's is converted.
/// Throws FileError.
Pixels8 readPixels8(const std::filesystem::path& file);

}  // namespace candela::image
