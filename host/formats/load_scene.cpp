// The list of loaders, and the choice among them for a file.
#include "host/formats/load_scene.h"

#include <vector>

#include "host/gltf/gltf_loader.h"
#include "host/scene/nff_loader.h"
#include "host/scene/read_file.h"

namespace candela::formats {

std::span<const scene::Loader> allLoaders() {
  static const std::vector<scene::Loader> loaders{gltf::gltfLoader(), scene::nffLoader()};
  return loaders;
}

scene::LoadedScene loadScene(const std::filesystem::path& path, const scene::LoadOptions& options) {
  const std::string bytes = scene::readFile(path);
  const scene::SceneFile file{bytes, path.string(), scene::folderOrCurrent(path.parent_path())};
  return chooseLoader(allLoaders(), file).load(file, options);
}

}  // namespace candela::formats
