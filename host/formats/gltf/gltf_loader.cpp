// The loader of glTF: container, checks, nodes, view, default light.
#include "host/formats/gltf/gltf_loader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "host/base/hash.h"
#include "host/base/setting_words.h"
#include "host/formats/gltf/default_light.h"
#include "host/formats/gltf/extensions.h"
#include "host/formats/gltf/scene_assembly.h"
#include "host/formats/loading/scene_checks.h"

namespace candela::gltf {
namespace {

// Hash of everything that decides the scene: the file, its buffers and images, and the options.
std::uint64_t hashOf(const scene::SceneFile& file, const scene::LoadOptions& options, const Buffers& buffers,
                     const Textures& textures) {
  std::uint64_t hash = textures.hashFiles(buffers.hashFiles(fnv1aOfText(file.bytes)));
  if (options.camera) hash = fnv1aOfText("camera " + *options.camera, hash);
  if (options.time) hash = fnv1aOfText(fmt::format("time {}", *options.time), hash);
  if (options.animation) hash = fnv1aOfText("animation " + *options.animation, hash);
  return hash;
}

/// Half the diagonal of the scene, in its own units.
void setReach(const std::optional<Box>& bounds, scene::Scene& scene) {
  if (!bounds) return;
  const auto reach = static_cast<float>(glm::length(bounds->max - bounds->min) / 2);
  for (scene::PunctualLight& light : scene.punctualLights) light.reach = reach;
}

scene::FileFacts factsOf(const UsedExtensions& used, const std::string& view, const std::string& light) {
  const auto listOf = [](const std::vector<std::string>& names) {
    return names.empty() ? std::string("none") : fmt::format("{}", fmt::join(names, ", "));
  };
  scene::FileFacts facts{{"view", view}, {"light", light}, {"extensions", listOf(used.all)}};
  if (!used.partly.empty()) facts.emplace_back("partly", listOf(used.partly));
  if (!used.unsupported.empty()) facts.emplace_back("unsupported", listOf(used.unsupported));
  return facts;
}

bool hasExtent(const Box& bounds) { return bounds.min != bounds.max; }

// Vertices are rounded to single precision, whose resolution falls with the distance from the origin.
void warnOfExtent(const std::optional<Box>& bounds, scene::DiagnosticLog& log) {
  constexpr double kMinSteps = 4096;  // along the diagonal of the model
  if (!bounds) return;
  if (!hasExtent(*bounds)) {
    log.warn("extent", {}, "the model has no extent: all of its vertices are at one point, as with a scale of 0");
    return;
  }
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max({largest, std::abs(bounds->min[axis]), std::abs(bounds->max[axis])});
  const double step = std::ldexp(1.0, std::ilogb(largest) - 23);
  const double steps = glm::length(bounds->max - bounds->min) / step;
  if (steps >= kMinSteps) return;
  log.warn("extent", {},
           fmt::format("the model is so far from the origin that single precision resolves only 1/{:.0f} of its size "
                       "({:.2g} units at a distance of {:.2g}); move it, its camera and its lights to the origin",
                       steps, step, largest));
}

// Cameras that a program left in the file often show the model as a few pixels, or not at all.
void warnOfSmallModel(const View& view, const std::optional<Box>& bounds, scene::DiagnosticLog& log) {
  constexpr double kMinCoverage = 0.01;
  if (!bounds || !hasExtent(*bounds) || coverageOf(view.camera, *bounds) >= kMinCoverage) return;
  log.warn("view", {},
           fmt::format("{} shows the model in less than 1 % of the picture; {} frames the model", view.description,
                       settingWords("camera", "none")));
}

scene::LoadedScene assemble(const scene::SceneFile& file, const scene::LoadOptions& options,
                            scene::DiagnosticLog& log) {
  Container container = readContainer(file);
  const Value root(container.json, "");
  const UsedExtensions used = checkAsset(root, options.lenient, log);
  Buffers buffers(root, container.binary, file, options);
  Accessors accessors(root, buffers, options.lenient ? &log : nullptr);
  if (options.time && root.sizeOf("animations") == 0) {
    log.warn("time", {}, settingWords("time") + " has no effect: the file has no animation");
  }
  const Pose pose = options.time ? poseAt(root, options.animation, *options.time, accessors, container.json) : Pose{};
  const NodeTree nodes(root, pose, options.lenient, log);
  SceneAssembly assembly(root, nodes, pose, accessors, buffers, options.lenient, log);
  assembly.addMaterials();
  assembly.addNodes();
  assembly.dropUselessOpacity();
  log.throwIfErrors();
  assembly.reportOmissions();
  scene::Scene& scene = assembly.scene();
  const View view = chooseView(root, nodes, options.camera, assembly.bounds());
  scene.camera = view.camera;
  warnOfExtent(assembly.bounds(), log);
  if (!options.camera) warnOfSmallModel(view, assembly.bounds(), log);
  const std::string light = lightUp(scene, assembly.bounds(), options);
  warnOfShadows(scene, log);
  setReach(assembly.bounds(), scene);
  checkScene(scene, options, log);
  scene.name = std::filesystem::path(file.name).filename().string();
  scene.hash = hashOf(file, options, buffers, assembly.textures());
  scene::FileFacts facts = factsOf(used, view.description, light);
  if (assembly.hasOcclusion()) facts.emplace_back("not used", "occlusion textures (light is traced)");
  return {std::move(scene), assembly.counts(), log.warnings(), std::move(facts), buffers.files()};
}

}  // namespace

scene::Loader gltfLoader() { return {"glTF 2.0", {".gltf", ".glb"}, looksLikeGltf, loadGltf}; }

scene::LoadedScene loadGltf(const scene::SceneFile& file, const scene::LoadOptions& options) {
  scene::DiagnosticLog log(file.name);
  try {
    return assemble(file, options, log);
  } catch (const scene::SceneError&) {
    throw;
  } catch (const FileError& error) {
    throw scene::SceneError({{file.name, 0, 0, error.what()}});
  }
}

}  // namespace candela::gltf
