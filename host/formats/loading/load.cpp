// Checks of scenes that were read, and paths.
#include "host/formats/loading/load.h"

namespace candela::scene {

std::filesystem::path folderOrCurrent(const std::filesystem::path& folder) { return folder.empty() ? "." : folder; }

void requireCamera(const Scene& scene) {
  if (scene.camera) return;
  throw SceneError(
      {{scene.name, 0, 0,
        "the scene has no view; add one: v / from x y z / at x y z / up x y z / angle degrees / hither 0 / "
        "resolution width height"}});
}

}  // namespace candela::scene
