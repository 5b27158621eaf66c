// Reads the six images of a sky box, only from permitted folders.
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "host/scene/scene.h"

namespace candela::scene {

/// Maximum side of a face, in texels.
inline constexpr std::uint32_t kMaxSkySide = 8192;

/// Reads the images right, left, top, bottom, front and back in `folder`, each .jpg, .jpeg or .png. With links
/// resolved, the folder and each image must be in one of the `permitted` folders. Returns an empty value if the folder
/// does not exist. Throws FileError.
std::optional<Sky> loadSky(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& permitted);

}  // namespace candela::scene
