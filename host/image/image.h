// Images in memory and image files.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/image/film.h"
#include "host/image/texels.h"

namespace candela::image {

/// A rectangle of pixels in the plane of a picture: columns from `x` and rows from `y`, which count downwards. The
/// edges fit in 32 bits with a sign.
struct PixelBox {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t width = 0;
  std::int64_t height = 0;

  bool isEmpty() const { return width <= 0 || height <= 0; }
  bool contains(const PixelBox& box) const {
    return box.x >= x && box.y >= y && box.x + box.width <= x + width && box.y + box.height <= y + height;
  }
  bool operator==(const PixelBox&) const = default;
};

/// Returns the pixels that are in both; isEmpty() if there are none.
inline PixelBox intersection(const PixelBox& a, const PixelBox& b) {
  const std::int64_t x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

/// Returns "X,Y,WIDTH,HEIGHT", as --crop takes it.
std::string boxText(const PixelBox& box);

/// Values of a named channel, one for each pixel, row by row from the top. If `isId` is true, the bits of the values
/// are integers or hashes, and only their equality has a meaning.
struct Channel {
  std::string name;
  std::vector<float> values;
  bool isId = false;
};

/// Linear RGB, row by row from the top. The other vectors (variance of the luminance of one sample, number of samples,
/// number of bad samples, alpha) have one entry per pixel, or none if the image does not have them.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<glm::vec3> rgb;
  std::vector<float> luminanceVariance;
  std::vector<std::uint32_t> sampleCounts;
  std::vector<std::uint32_t> badSampleCounts;  ///< FilmPixel::badCount
  std::map<std::string, std::string> metadata;
  std::vector<float> alpha{};       ///< in [0, 1]; `rgb` is premultiplied, that is, over black
  std::vector<Channel> channels{};  ///< of layers; only EXR files have them
  glm::i64vec2 origin{0};           ///< column and row of the first pixel in the plane of the picture
  std::optional<PixelBox> frame{};  ///< the whole picture (OpenEXR's display window), of which the pixels may be a part
                                    ///< or more; none: the pixels, from (0, 0)
  bool isCubeMap = false;           ///< an EXR file says that its pixels are the six faces of an environment
  std::vector<std::string> warnings{};  ///< what the file states about its pixels and the reader did not apply
  bool isDisplayReferred = false;       ///< the file has integers, which a display transform made: PNG, JPEG, WebP
  std::uint32_t significandBits = 24;   ///< of the file's colours: 24 for binary32, 11 for half, 8 for RGBE

  glm::vec3& at(std::uint32_t x, std::uint32_t y) { return rgb[std::size_t{y} * width + x]; }
  const glm::vec3& at(std::uint32_t x, std::uint32_t y) const { return rgb[std::size_t{y} * width + x]; }
};

/// Returns the place of the image's pixels in the plane of the picture (OpenEXR's data window).
PixelBox windowOf(const Image& image);
/// Returns the frame of the picture (OpenEXR's display window).
PixelBox frameOf(const Image& image);
/// Returns the pixels of an image that are in `window`, which windowOf(image) must contain.
Image partOf(const Image& image, const PixelBox& window);

/// Returns the means of the film, rounded once to binary32, with variances and counts. If there are bad samples, the
/// image has their counts, and the metadata entry "candela.badSamples" has their total.
Image toImage(const Film& film);
/// Adds the film's alpha to the image of the film.
void addAlpha(Image& image, const Film& film);
/// Returns the values of one of a layer's channels (see layerChannelNames), which the film must have and which is not a
/// matte.
std::vector<float> layerChannelValues(const Film& film, Layer layer, std::size_t channel);
/// Adds the channels of the film's layers to the image of the film: docs/layers.md.
void addLayers(Image& image, const Film& film);
/// Returns the sum of `badSampleCounts`.
std::uint64_t badSampleCount(const Image& image);

enum class ToneMap { none, srgb, aces, acesHill, agx, neutral, depth, heat };

/// Conversion of linear RGB to 8-bit pixels: radiance * 2^exposure, then the tone curve, then (except for `none`) the
/// sRGB transfer function, then round(255 x). `none` clips the linear value and applies no transfer function. NaN and
/// negative values become black. The curves: `aces` is Narkowicz' fit (2016), `acesHill` Hill's fit of ACES as in
/// three.js, `agx` Wrensch's polynomial (2023), `neutral` Khronos PBR Neutral (2024), and `srgb` has no curve. `depth`
/// and `heat` are false colours, which are signals without a transfer function. With v = red channel * 2^exposure /
/// scale, `depth` shows the grey 1 / (1 + v^2), or black where v is 0 because nothing was hit; `heat` shows magma(v)
/// (host/image/colour_map.h).
struct DisplayTransform {
  ToneMap toneMap = ToneMap::srgb;
  float exposure = 0;  ///< stops
  float scale = 1;     ///< of false colours, > 0
};
glm::u8vec3 toDisplay(const glm::vec3& linear, const DisplayTransform& transform);

/// Maximum size of images that are read or written.
inline constexpr std::uint32_t kMaxImageSide = 65535;
inline constexpr std::uint64_t kMaxImagePixels = std::uint64_t{1} << 28;

/// 8-bit RGB pixels, 3 bytes each, row by row from the top.
struct Pixels8 {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgb;
  std::vector<std::uint8_t> alpha{};  ///< straight, one byte per pixel; empty: opaque
};
/// Converts an image; an image with alpha is composited over black.
Pixels8 toPixels8(const Image& image, const DisplayTransform& transform);
/// Converts an image with its alpha: the transform applies to the colours divided by alpha, which are black where alpha
/// is 0.
Pixels8 toStraightPixels8(const Image& image, const DisplayTransform& transform);
/// Returns the bytes of a PNG file. Throws FileError for an image without pixels or beyond the limits above.
std::vector<std::byte> toPng(const Pixels8& pixels);
/// Converts sRGB signals to linear values.
Image toImage(const Pixels8& pixels);
/// Converts the signals of a file of integers to linear values, and multiplies them by alpha, which the image has if a
/// texel is not opaque.
Image toImage(const Texels& texels);

/// Returns whether the name stands for stdout: `-`, which receives a PNG file, or `-.exr` and so on, which name the
/// format. (`./-.exr` is a file.)
bool isStandardOutput(const std::filesystem::path& file);

/// Checks the file name. Formats, by extension in any case: .png (8 bits, display transform, straight alpha), .jpg and
/// .jpeg (quality 95), .hdr (Radiance RGBE, negative values become 0), .pfm (binary32, little-endian), .exr (binary32
/// linear Rec. 709, ZIP; channels R G B and, if the image has them, A, by which R G B are multiplied, `variance.Y`,
/// `samples` and `badSamples`, and the channels of layers; the windows; the metadata as string attributes). The other
/// formats show an image with alpha over black. Throws UsageError for any other extension.
void checkImageFormat(const std::filesystem::path& file);
/// Returns whether the extension is that of a format in which images are read and written.
bool hasImageExtension(const std::filesystem::path& file);
/// Returns whether such a file has 8-bit pixels, made by a display transform. Throws as checkImageFormat does.
bool isEightBit(const std::filesystem::path& file);
/// Returns whether such a file is an EXR file, which has the channels of layers. Throws as checkImageFormat does.
bool isExr(const std::filesystem::path& file);
/// Writes an image file atomically, or to stdout: an error leaves no incomplete file. Equal images give equal bytes.
/// Throws UsageError for the extension; FileError if the image is empty or too large, if the metadata use a name that
/// EXR reserves, or if the file cannot be written.
void writeImage(const std::filesystem::path& file, const Image& image, const DisplayTransform& transform);
enum class ImageParts {
  picture,     ///< colours, alpha, variances, counts and metadata
  withLayers,  ///< `channels`, too: all channels of an EXR file at full resolution, except statistics of films
};
/// Reads a file of any format below, distinguished by its first bytes. Invalid files give a FileError, never a crash.
/// PNG (8 and 16 bits), JPEG and WebP are converted from sRGB, or from the gamma that a PNG states, and multiplied by
/// their alpha. From an EXR file, which must have a single flat part, it reads the data window: R, G and B, those of
/// its only layer, or its only channel as grey; A, `variance.Y`, `samples`, `badSamples` and the string attributes. HDR
/// pixels are divided by the file's EXPOSURE and COLORCORR, and PFM pixels multiplied by the scale. Colours of other
/// primaries are converted to Rec. 709.
Image readImage(const std::filesystem::path& file, ImageParts parts = ImageParts::picture);

}  // namespace candela::image
