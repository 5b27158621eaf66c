// Reads the six images of a sky box, only from permitted folders.
#include "host/scene/sky.h"

#include <fmt/format.h>

#include <array>

#include "host/core/errors.h"
#include "host/image/image.h"
#include "host/scene/quote.h"

namespace candela::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFaceNames{"right", "left", "top", "bottom", "front", "back"};
constexpr std::array kExtensions{".jpg", ".jpeg", ".png"};

fs::path findFace(const fs::path& folder, const std::string& name) {
  for (const char* extension : kExtensions) {
    const fs::path file = folder / (name + extension);
    std::error_code error;
    if (fs::exists(file, error)) return file;
  }
  throw FileError(fmt::format("the sky box {} has no {}.jpg or {}.png", quote(folder.string()), name, name));
}

SkyFace readFace(const fs::path& file) {
  image::Pixels8 pixels = image::readPixels8(file);
  const bool fits = pixels.width <= kMaxSkySide && pixels.height <= kMaxSkySide;
  if (!fits) {
    throw FileError(fmt::format("{} has {} x {} pixels; a face of a sky box may have at most {} per side",
                                quote(file.string()), pixels.width, pixels.height, kMaxSkySide));
  }
  return {pixels.width, pixels.height, std::move(pixels.rgb)};
}

}  // namespace

std::optional<Sky> loadSky(const fs::path& folder, PathGuard& guard) {
  guard.require(folder);
  std::error_code error;
  if (!fs::is_directory(folder, error)) return std::nullopt;
  Sky sky;
  for (std::size_t i = 0; i < kFaceNames.size(); ++i) {
    const fs::path file = findFace(folder, kFaceNames[i]);
    guard.require(file);
    sky.faces[i] = readFace(file);
  }
  return sky;
}

}  // namespace candela::scene
