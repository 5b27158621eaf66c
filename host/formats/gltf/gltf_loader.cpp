// The loader of glTF: container, checks, nodes, view, default light.
#include "host/formats/gltf/gltf_loader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/hash.h"
#include "host/base/setting_words.h"
#include "host/formats/gltf/extensions.h"
#include "host/formats/gltf/scene_assembly.h"
#include "host/formats/loading/default_light.h"
#include "host/formats/loading/file_hash.h"
#include "host/formats/loading/scene_checks.h"

namespace candela::gltf {
namespace {

// Hash of everything that decides the scene: the file, its buffers and images, and the options.
std::uint64_t hashOf(std::uint64_t fileHash, const scene::LoadOptions& options, const Buffers& buffers,
                     const Textures& textures) {
  std::uint64_t hash = textures.hashFiles(buffers.hashFiles(fileHash));
  if (options.camera) hash = fnv1aOfText("camera " + *options.camera, hash);
  if (options.time) hash = fnv1aOfText(fmt::format("time {}", *options.time), hash);
  if (options.animation) hash = fnv1aOfText("animation " + *options.animation, hash);
  return hash;
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

// Cameras that a program left in the file often show the model as a few pixels, or not at all.
void warnOfSmallModel(const View& view, const std::optional<scene::Bounds>& bounds, scene::DiagnosticLog& log) {
  constexpr double kMinCoverage = 0.01;
  if (!bounds || !scene::hasExtent(*bounds) || scene::coverageOf(view.camera, *bounds) >= kMinCoverage) return;
  log.warn("view", {},
           fmt::format("{} shows the model in less than 1 % of the picture; {} frames the model", view.description,
                       settingWords("camera", "none")));
}

scene::Bounds unionOf(const scene::Bounds& a, const scene::Bounds& b) {
  return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

/// Turns errors of files and of JSON into errors of the scene.
template <class Action>
auto withSceneErrors(const scene::SceneFile& file, const Action& action) {
  try {
    return action();
  } catch (const scene::SceneError&) {
    throw;
  } catch (const FileError& error) {
    throw scene::SceneError({{file.name, 0, 0, error.what()}});
  }
}

/// A scene of the file while it is read. The members are made in their order.
struct Reading {
  /// `fileRoot` is the content of the file; `options` have the time of the scene.
  Reading(const Value& fileRoot, Buffers& buffers, DecodedImages* decoded, const scene::LoadOptions& options,
          const std::string& name)
      : log(name),
        used(checkAsset(fileRoot, options.lenient, log)),
        accessors(fileRoot, buffers, options.lenient ? &log : nullptr),
        posed(options.time && hasPointers(fileRoot) ? fileRoot.json() : nlohmann::json()),
        root(posed.is_null() ? fileRoot : Value(posed, "")),
        pose(options.time ? poseAt(fileRoot, options.animation, *options.time, accessors, posed) : Pose{}),
        nodes(root, pose, options.lenient, log),
        assembly(root, nodes, pose, accessors, buffers, options.lenient, decoded, log) {
    assembly.addMaterials();
    assembly.addNodes();
    assembly.dropUselessOpacity();
    log.throwIfErrors();
    bounds = assembly.bounds();
  }

  scene::DiagnosticLog log;
  UsedExtensions used;
  Accessors accessors;
  nlohmann::json posed;  ///< the content with the values that pointers animate; null: nothing is animated by them
  Value root;
  Pose pose;
  NodeTree nodes;
  SceneAssembly assembly;
  std::optional<scene::Bounds> bounds{};  ///< SceneAssembly::bounds()
};

/// A file, and what its scenes share. A view that frames the model, the distance of a camera's target and the default
/// light stay as they are while the model moves: the view frames the whole motion, and the others are those of the
/// model at rest.
class GltfReader final : public scene::SceneReader {
 public:
  GltfReader(const scene::SceneFile& file, const scene::LoadOptions& options, bool isOften)
      : file_(file),
        options_(options),
        fileHash_(scene::startHash(file_.bytes)),
        container_(readContainer(file_)),
        root_(container_.json, ""),
        isAnimated_(root_.sizeOf("animations") > 0),
        keepsImages_(isOften || isAnimated_),
        buffers_(root_, container_.binary, file_, options_) {}

  scene::LoadedScene at(std::optional<double> time) override {
    return withSceneErrors(file_, [&] { return sceneAt(time); });
  }

 private:
  /// The model at rest. Both members are empty if it has errors there that it does not have in motion.
  struct Rest {
    std::optional<scene::Bounds> bounds{};
    std::optional<scene::DefaultLight> light{};
  };

  scene::LoadedScene sceneAt(std::optional<double> time) {
    buffers_.beginScene();
    Reading reading = read(time);
    buffers_.endScene();
    SceneAssembly& assembly = reading.assembly;
    scene::DiagnosticLog& log = reading.log;
    if (time && !isAnimated_) log.warn("time", {}, settingWords("time") + " has no effect: the file has no animation");
    assembly.reportOmissions();
    scene::Scene& scene = assembly.scene();
    const bool isPosed = time && isAnimated_;
    if (isPosed && !rest_) rest_ = readRest();
    const View view = viewOf(reading, time);
    scene.camera = view.camera;
    scene::warnOfExtent(reading.bounds, log);
    if (!options_.camera) warnOfSmallModel(view, reading.bounds, log);
    const scene::DefaultLight light = isPosed && rest_->light ? *rest_->light
                                                              : scene::defaultLightOf(scene, reading.bounds);
    const std::string lightText = scene::lightUp(scene, light, options_);
    scene::warnOfShadows(scene, log);
    scene::setReach(reading.bounds, scene);
    checkScene(scene, options_, log);
    scene.name = std::filesystem::path(file_.name).filename().string();
    scene.hash = hashOf(fileHash_.get(), optionsAt(time), buffers_, assembly.textures());
    scene::FileFacts facts = factsOf(reading.used, view.description, lightText);
    if (assembly.hasOcclusion()) facts.emplace_back("not used", "occlusion textures (light is traced)");
    return {std::move(scene), assembly.counts(), log.warnings(), std::move(facts), buffers_.files(), end()};
  }

  scene::LoadOptions optionsAt(std::optional<double> time) const {
    scene::LoadOptions options = options_;
    options.time = time;
    return options;
  }

  Reading read(std::optional<double> time) {
    return Reading(root_, buffers_, keepsImages_ ? &images_ : nullptr, optionsAt(time), file_.name);
  }

  View viewOf(Reading& reading, std::optional<double> time) {
    const std::optional<scene::Bounds>& bounds = reading.bounds;
    const bool isPosed = time && isAnimated_;
    const auto framed = [&] { return isPosed ? motion() : bounds; };
    const std::optional<scene::Bounds>& targeted = isPosed && rest_->bounds ? rest_->bounds : bounds;
    return chooseView(reading.root, reading.nodes, options_.camera, targeted, framed);
  }

  Rest readRest() {
    try {
      Reading reading = read(std::nullopt);
      reading.assembly.scene().camera = viewOf(reading, std::nullopt).camera;
      return {reading.bounds, scene::defaultLightOf(reading.assembly.scene(), reading.bounds)};
    } catch (const FileError&) {
      return {};
    }
  }

  /// Returns nothing for a pose with errors.
  std::optional<scene::Bounds> boundsAt(double time) {
    try {
      return read(time).bounds;
    } catch (const FileError&) {
      return std::nullopt;
    }
  }

  /// Returns the bounds of the model at rest and at several times of its animation.
  const std::optional<scene::Bounds>& motion() {
    constexpr int kSteps = 8;
    if (motion_) return *motion_;
    motion_ = rest_->bounds;
    for (int i = 0; i <= kSteps; ++i) {
      const std::optional<scene::Bounds> bounds = boundsAt(end().value_or(0) * i / kSteps);
      if (bounds) *motion_ = *motion_ ? unionOf(**motion_, *bounds) : *bounds;
    }
    return *motion_;
  }

  /// Animations with errors have no end: they are refused when a scene has a time.
  std::optional<double> end() {
    if (!end_) {
      try {
        Accessors accessors(root_, buffers_);
        end_.emplace(animationEnd(root_, options_.animation, accessors));
      } catch (const FileError&) {
        end_.emplace();
      }
    }
    return *end_;
  }

  scene::SceneFile file_;
  scene::LoadOptions options_;
  std::shared_future<std::uint64_t> fileHash_;
  Container container_;
  Value root_;
  bool isAnimated_;
  bool keepsImages_;
  Buffers buffers_;
  DecodedImages images_{};
  std::optional<Rest> rest_{};                            ///< once it was needed
  std::optional<std::optional<scene::Bounds>> motion_{};  ///< once it was needed
  std::optional<std::optional<double>> end_{};            ///< once it was needed
};

std::unique_ptr<scene::SceneReader> openGltf(const scene::SceneFile& file, const scene::LoadOptions& options,
                                             bool isOften) {
  return withSceneErrors(file, [&] { return std::make_unique<GltfReader>(file, options, isOften); });
}

}  // namespace

scene::Loader gltfLoader() { return {"glTF 2.0", {".gltf", ".glb"}, looksLikeGltf, openGltf}; }

}  // namespace candela::gltf
