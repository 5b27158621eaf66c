// Reads the six images of a sky box, only from permitted folders.
#pragma once
#include <filesystem>
#include <optional>

#include "host/scene/path_guard.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// Maximum side of a face, in texels.
inline constexpr std::uint32_t kMaxSkySide = 8192;

/// `folder` holds right, left, top, bottom, front and back, each .jpg, .jpeg or .png. The folder and each image, links
/// resolved, must be permitted by `guard`. Empty if there is no such folder. Throws FileError.
std::optional<Sky> loadSky(const std::filesystem::path& folder, PathGuard& guard);

}  // namespace candela::scene
