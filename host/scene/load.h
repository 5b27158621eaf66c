// Reads scene files, each by the loader of its format (host/scene/loader.h).
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/scene/diagnostic.h"
#include "host/scene/scene.h"

namespace candela::scene {

struct LoadOptions {
  bool lenient = false;  ///< skip unknown lines and complete short materials, each with a warning
  std::vector<std::filesystem::path> allowedPaths{};  ///< folders, besides the scene's own, from which a scene may read
};

/// Number of statements of each kind in the file: "sphere", "polygon", "patch", "material", ...
using StatementCounts = std::map<std::string, std::uint64_t>;

struct LoadedScene {
  Scene scene;
  StatementCounts counts;
  std::vector<Diagnostic> warnings;
};

/// The format is recognised by the file's content, or else by its extension. Throws SceneError with every error that
/// was found, and FileError if the file cannot be read or is larger than 1 GiB. A file without a view loads:
/// Scene::camera is then empty, and the caller decides (requireCamera).
LoadedScene loadScene(const std::filesystem::path& path, const LoadOptions& options = {});
/// Reads NFF or P3F from memory. `name` is used in messages; `env` paths are relative to `folder`.
LoadedScene parseScene(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       const LoadOptions& options = {});
/// Throws SceneError, with the syntax of a view, if the scene has no view.
void requireCamera(const Scene& scene);

}  // namespace candela::scene
