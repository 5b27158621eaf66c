// Reads NFF and P3F files in all their dialects.
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
  bool lenient = false;  ///< unknown lines are skipped, short materials completed, each with a warning
  std::vector<std::filesystem::path> allowedPaths{};  ///< folders outside the scene's own that `env` may name
};

/// How many statements of each kind the file had: "sphere", "polygon", "patch", "material", ...
using StatementCounts = std::map<std::string, std::uint64_t>;

struct LoadedScene {
  Scene scene;
  StatementCounts counts;
  std::vector<Diagnostic> warnings;
};

/// Throws SceneError with every error that was found. A file without a view loads: Scene::camera is then empty, and
/// the caller decides (requireCamera).
LoadedScene loadScene(const std::filesystem::path& file, const LoadOptions& options = {});
/// The same from memory; `name` stands in messages, `folder` is where `env` paths start.
LoadedScene parseScene(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       const LoadOptions& options = {});
/// Throws SceneError, which says how to give a view, if there is none.
void requireCamera(const Scene& scene);

}  // namespace candela::scene
