// The list of loaders, and the choice among them for a file.
#include "host/formats/load_scene.h"

#include <fmt/format.h>

#include <vector>

#include "host/base/errors.h"
#include "host/base/hash.h"
#include "host/base/setting_words.h"
#include "host/formats/gltf/gltf_loader.h"
#include "host/formats/loading/read_file.h"
#include "host/formats/mitsuba/mitsuba_loader.h"
#include "host/formats/nff/nff_loader.h"
#include "host/formats/obj/obj_loader.h"
#include "host/formats/orbit.h"
#include "host/formats/ply/ply_loader.h"

namespace candela::formats {
namespace {

/// Gives a scene its environment, which is read unless `read` has it already.
void surround(scene::LoadedScene& loaded, const scene::LoadOptions& options,
              std::optional<environment::ReadEnvironment>& read) {
  scene::Scene& scene = loaded.scene;
  const std::string& source = options.environment.source;
  if (environment::isImageFile(source)) loaded.files.emplace_back(source);
  if (!read) read = environment::readEnvironment(options.environment, scene.up, options.lenient);
  for (const std::string& warning : read->warnings) loaded.warnings.push_back({source, 0, 0, warning});
  scene.environment = read->environment;
  scene.hash = environment::hashOf(*scene.environment, scene.hash);
  loaded.facts.emplace_back("environment", fmt::format("{}, {} x {} texels", scene.environment->name,
                                                       scene.environment->width, scene.environment->height));
}

void orbit(scene::Scene& scene, double degrees) {
  if (degrees == 0) return;
  if (scene.camera) scene.camera = orbitedCamera(scene, degrees);
  scene.hash = fnv1aOfText(fmt::format("orbit {}", degrees), scene.hash);
}

std::string bytesOf(const std::filesystem::path& path) {
  std::string bytes = scene::readFile(path, InputKind::regularFileOrPipe);
  if (bytes.empty()) throw scene::SceneError({{path.string(), 0, 0, "the file is empty"}});
  if (bytes.starts_with("\xfe\xff") || bytes.starts_with("\xff\xfe")) {
    throw scene::SceneError({{path.string(), 0, 0, "the file is text in UTF-16; save it in UTF-8"}});
  }
  return bytes;
}

scene::SceneFile fileOf(const std::filesystem::path& path, std::string_view bytes) {
  return {bytes, path.string(), scene::folderOrCurrent(path.parent_path())};
}

std::unique_ptr<scene::SceneReader> open(const scene::SceneFile& file, const scene::LoadOptions& options,
                                         bool isOften) {
  const scene::Loader& loader = chooseLoader(allLoaders(), file);
  if (!options.definitions.empty() && !loader.hasParameters) {
    throw UsageError(fmt::format("{}: {} is no scene of Mitsuba, whose parameters it would set",
                                 settingWords("define", options.definitions.front()), file.name));
  }
  return loader.open(file, options, isOften);
}

scene::LoadedScene complete(scene::LoadedScene loaded, const scene::LoadOptions& options,
                            std::optional<environment::ReadEnvironment>& environment) {
  if (options.hasEnvironment()) surround(loaded, options, environment);
  orbit(loaded.scene, options.orbit);
  return loaded;
}

}  // namespace

std::span<const scene::Loader> allLoaders() {
  static const std::vector<scene::Loader> loaders{gltf::gltfLoader(), ply::plyLoader(), mitsuba::mitsubaLoader(),
                                                  obj::objLoader(), scene::nffLoader()};
  return loaders;
}

SceneSource::SceneSource(const std::filesystem::path& path, scene::LoadOptions options)
    : bytes_(bytesOf(path)), options_(std::move(options)), reader_(open(fileOf(path, bytes_), options_, true)) {}

SceneSource::~SceneSource() = default;

scene::LoadedScene SceneSource::at(std::optional<double> time, double orbit) {
  options_.time = time;
  options_.orbit = orbit;
  if (time) return complete(reader_->at(time), options_, environment_);
  if (!atRest_) atRest_ = reader_->at(time);
  return complete(*atRest_, options_, environment_);
}

scene::LoadedScene loadScene(const scene::SceneFile& file, const scene::LoadOptions& options) {
  std::optional<environment::ReadEnvironment> environment;
  return complete(open(file, options, false)->at(options.time), options, environment);
}

scene::LoadedScene loadScene(const std::filesystem::path& path, const scene::LoadOptions& options) {
  const std::string bytes = bytesOf(path);
  return loadScene(fileOf(path, bytes), options);
}

}  // namespace candela::formats
