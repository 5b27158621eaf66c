// The list of loaders, and the choice among them for a file.
#include "host/formats/load_scene.h"

#include <fmt/format.h>

#include <vector>

#include "host/formats/gltf/gltf_loader.h"
#include "host/formats/loading/read_file.h"
#include "host/formats/nff/nff_loader.h"
#include "host/scene/environment/environment.h"

namespace candela::formats {
namespace {

void surround(scene::LoadedScene& loaded, const scene::EnvironmentRequest& request, bool isLenient) {
  scene::Scene& scene = loaded.scene;
  if (environment::isImageFile(request.source)) loaded.files.emplace_back(request.source);
  environment::ReadEnvironment read = environment::readEnvironment(request, scene.up, isLenient);
  for (const std::string& warning : read.warnings) loaded.warnings.push_back({request.source, 0, 0, warning});
  scene.environment = std::move(read.environment);
  scene.hash = environment::hashOf(*scene.environment, scene.hash);
  loaded.facts.emplace_back("environment", fmt::format("{}, {} x {} texels", scene.environment->name,
                                                       scene.environment->width, scene.environment->height));
}

}  // namespace

std::span<const scene::Loader> allLoaders() {
  static const std::vector<scene::Loader> loaders{gltf::gltfLoader(), scene::nffLoader()};
  return loaders;
}

scene::LoadedScene loadScene(const scene::SceneFile& file, const scene::LoadOptions& options) {
  scene::LoadedScene loaded = chooseLoader(allLoaders(), file).load(file, options);
  if (options.hasEnvironment()) surround(loaded, options.environment, options.lenient);
  return loaded;
}

scene::LoadedScene loadScene(const std::filesystem::path& path, const scene::LoadOptions& options) {
  const std::string bytes = scene::readFile(path, InputKind::regularFileOrPipe);
  if (bytes.empty()) throw scene::SceneError({{path.string(), 0, 0, "the file is empty"}});
  return loadScene({bytes, path.string(), scene::folderOrCurrent(path.parent_path())}, options);
}

}  // namespace candela::formats
