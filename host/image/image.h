// Images in memory and their files.
#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/image/film.h"

namespace candela {

/// Linear RGB, row by row from the top. `variance` (of the luminance of one sample) and `sampleCount` have one entry
/// per pixel, or none where the file did not carry them.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<glm::vec3> rgb;
  std::vector<float> luminanceVariance;
  std::vector<std::uint32_t> sampleCounts;
  std::map<std::string, std::string> metadata;

  glm::vec3& at(std::uint32_t x, std::uint32_t y) { return rgb[std::size_t{y} * width + x]; }
  const glm::vec3& at(std::uint32_t x, std::uint32_t y) const { return rgb[std::size_t{y} * width + x]; }
};

/// The film's means, rounded once to binary32, with variance and counts.
Image toImage(const Film& film);

enum class ToneMap { none, srgb, aces, agx, neutral };

/// How linear RGB becomes 8-bit pixels: radiance * 2^exposure, then the curve, then (all but `none`) the sRGB transfer
/// function, then round(255 x). `none` clips the linear value and applies no transfer function.
struct DisplayTransform {
  ToneMap toneMap = ToneMap::srgb;
  float exposure = 0;  ///< stops
};
glm::u8vec3 toDisplay(const glm::vec3& linear, const DisplayTransform& transform);

/// Formats, by extension: .png (8 bit, display transform), .jpg, .hdr, .pfm, .exr (linear; EXR carries channels
/// R G B, `variance.Y`, `samples` and the metadata as string attributes).
/// Throws UsageError for an extension that is not one of them.
void checkImageFormat(const std::filesystem::path& file);
/// Writes beside, syncs, renames: an error leaves no half-written file. Throws FileError.
void writeImage(const std::filesystem::path& file, const Image& image, const DisplayTransform& transform);
/// Reads .png, .jpg (decoded from sRGB), .hdr, .pfm and .exr. Hostile files give a FileError, never a crash.
Image readImage(const std::filesystem::path& file);
/// 8-bit RGB pixels of a .png, .jpg or .jpeg, 3 bytes each from the top, as stored. Throws FileError.
struct Pixels8 {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgb;
};
Pixels8 readPixels8(const std::filesystem::path& file);

}  // namespace candela
