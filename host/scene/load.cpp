// Reads a scene file and passes it to the loader of its format.
#include "host/scene/load.h"

#include "host/scene/loader.h"
#include "host/scene/nff_loader.h"
#include "host/scene/read_file.h"

namespace candela::scene {
namespace {

std::filesystem::path folderOrCurrent(const std::filesystem::path& folder) { return folder.empty() ? "." : folder; }

}  // namespace

LoadedScene parseScene(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       const LoadOptions& options) {
  return loadNff({text, name, folderOrCurrent(folder)}, options);
}

LoadedScene loadScene(const std::filesystem::path& path, const LoadOptions& options) {
  const std::string bytes = readFile(path);
  const SceneFile file{bytes, path.string(), folderOrCurrent(path.parent_path())};
  return chooseLoader(allLoaders(), file).load(file, options);
}

void requireCamera(const Scene& scene) {
  if (scene.camera) return;
  throw SceneError(
      {{scene.name, 0, 0,
        "the scene has no view; add one: v / from x y z / at x y z / up x y z / angle degrees / hither 0 / "
        "resolution width height"}});
}

}  // namespace candela::scene
