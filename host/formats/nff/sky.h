// Reads the six images of a sky box, only from permitted folders.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/formats/loading/path_guard.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// Maximum side of a face, in texels.
inline constexpr std::uint32_t kMaxSkySide = 8192;

/// `folder` holds right, left, top, bottom, front and back, each an image file of a format that is read. The folder and
/// each image, links resolved, must be permitted by `guard`. Faces have 8 bits: brighter pixels are clipped, with a
/// warning. Empty if there is no such folder. Throws FileError.
std::optional<Sky> loadSky(const std::filesystem::path& folder, PathGuard& guard, std::vector<std::string>& warnings);

}  // namespace candela::scene
