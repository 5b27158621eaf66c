// Reads the six images of a sky box, only from permitted folders.
#include "host/formats/nff/sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/errors.h"
#include "host/base/quote.h"
#include "host/base/setting_words.h"
#include "host/image/image.h"

namespace candela::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFaceNames{"right", "left", "top", "bottom", "front", "back"};
constexpr std::array kExtensions{".jpg", ".jpeg", ".png", ".webp", ".hdr", ".exr", ".pfm"};

fs::path findFace(const fs::path& folder, const std::string& name) {
  for (const char* extension : kExtensions) {
    const fs::path file = folder / (name + extension);
    std::error_code error;
    if (fs::exists(file, error)) return file;
  }
  throw FileError(fmt::format("the sky box {} has no {}.jpg or {}.png", quote(folder.string()), name, name));
}

SkyFace readFace(const fs::path& file, std::vector<std::string>& warnings) {
  const image::Image image = image::readImage(file);
  for (const std::string& warning : image.warnings) warnings.push_back(fmt::format("{}: {}", file.string(), warning));
  const auto isBright = [](const glm::vec3& pixel) { return glm::any(glm::greaterThan(pixel, glm::vec3(1))); };
  if (std::ranges::any_of(image.rgb, isBright)) {
    warnings.push_back(fmt::format(
        "{}: values above 1 are clipped, since faces of sky boxes have 8 bits; {} reads maps of any brightness",
        file.string(), settingWords("env")));
  }
  image::Pixels8 pixels = toPixels8(image, {});
  const bool fits = pixels.width <= kMaxSkySide && pixels.height <= kMaxSkySide;
  if (!fits) {
    throw FileError(fmt::format("{} has {} x {} pixels; a face of a sky box may have at most {} per side",
                                quote(file.string()), pixels.width, pixels.height, kMaxSkySide));
  }
  return {pixels.width, pixels.height, std::move(pixels.rgb)};
}

}  // namespace

std::optional<Sky> loadSky(const fs::path& folder, PathGuard& guard, std::vector<std::string>& warnings) {
  guard.require(folder);
  std::error_code error;
  if (!fs::is_directory(folder, error)) return std::nullopt;
  Sky sky;
  for (std::size_t i = 0; i < kFaceNames.size(); ++i) {
    const fs::path file = findFace(folder, kFaceNames[i]);
    guard.require(file);
    sky.faces[i] = readFace(file, warnings);
  }
  return sky;
}

}  // namespace candela::scene
