// Reads the six images of a sky box, only from permitted folders.
#include "host/scene/sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/core/errors.h"
#include "host/image/image.h"
#include "host/scene/quote.h"

namespace candela::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFaceNames{"right", "left", "top", "bottom", "front", "back"};
constexpr std::array kExtensions{".jpg", ".jpeg", ".png"};

/// Returns the absolute path without links and dots. Components that do not exist are not changed. Returns an empty
/// path on failure.
fs::path resolve(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) return {};
  const fs::path resolved = fs::weakly_canonical(absolute, error);
  return error ? fs::path{} : resolved;
}

bool lies(const fs::path& resolvedPath, const fs::path& folder) {
  fs::path base = resolve(folder);
  if (resolvedPath.empty() || base.empty()) return false;
  if (base.filename().empty()) base = base.parent_path();  // a trailing slash
  return std::mismatch(base.begin(), base.end(), resolvedPath.begin(), resolvedPath.end()).first == base.end();
}

void requirePermitted(const fs::path& path, const std::vector<fs::path>& permitted) {
  const fs::path resolved = resolve(path);
  const bool inside = std::ranges::any_of(permitted, [&](const fs::path& folder) { return lies(resolved, folder); });
  if (inside) return;
  throw FileError(fmt::format("{} is outside the scene's folder; --allow-path DIR permits it", quote(path.string())));
}

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

std::optional<Sky> loadSky(const fs::path& folder, const std::vector<fs::path>& permitted) {
  requirePermitted(folder, permitted);
  std::error_code error;
  if (!fs::is_directory(folder, error)) return std::nullopt;
  Sky sky;
  for (std::size_t i = 0; i < kFaceNames.size(); ++i) {
    const fs::path file = findFace(folder, kFaceNames[i]);
    requirePermitted(file, permitted);
    sky.faces[i] = readFace(file);
  }
  return sky;
}

}  // namespace candela::scene
