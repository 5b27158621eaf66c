// Reads a scene from memory.
#include "host/scene/load.h"

#include "host/scene/nff_loader.h"

namespace candela::scene {

std::filesystem::path folderOrCurrent(const std::filesystem::path& folder) { return folder.empty() ? "." : folder; }

LoadedScene parseScene(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       const LoadOptions& options) {
  return loadNff({text, name, folderOrCurrent(folder)}, options);
}

void requireCamera(const Scene& scene) {
  if (scene.camera) return;
  throw SceneError(
      {{scene.name, 0, 0,
        "the scene has no view; add one: v / from x y z / at x y z / up x y z / angle degrees / hither 0 / "
        "resolution width height"}});
}

}  // namespace candela::scene
