// The loader of Mitsuba's XML: description, shapes, emitters, sensor and integrator.
#include "host/formats/mitsuba/mitsuba_loader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/base/hash.h"
#include "host/formats/loading/default_light.h"
#include "host/formats/loading/file_hash.h"
#include "host/formats/loading/framing.h"
#include "host/formats/loading/scene_checks.h"
#include "host/formats/loading/shrink_images.h"
#include "host/formats/mitsuba/emitters.h"
#include "host/formats/mitsuba/sensors.h"
#include "host/formats/mitsuba/shapes.h"
#include "host/scene/bounds.h"

namespace candela::mitsuba {
namespace {

/// Returns whether the first element is <scene>. A byte order mark, comments and processing instructions may precede
/// it.
bool looksLikeMitsuba(std::string_view bytes) {
  constexpr std::string_view kMark = "\xef\xbb\xbf", kBlanks = " \t\r\n";
  if (bytes.starts_with(kMark)) bytes.remove_prefix(kMark.size());
  while (true) {
    const std::size_t begin = bytes.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return false;
    bytes.remove_prefix(begin);
    const std::string_view end = bytes.starts_with("<!--") ? "-->" : bytes.starts_with("<?") ? "?>" : "";
    if (end.empty()) break;
    const std::size_t last = bytes.find(end);
    if (last == std::string_view::npos) return false;
    bytes.remove_prefix(last + end.size());
  }
  constexpr std::string_view kTag = "<scene";
  return bytes.starts_with(kTag) &&
         (bytes.size() == kTag.size() || (kBlanks.find(bytes[kTag.size()]) != std::string_view::npos ||
                                          bytes[kTag.size()] == '>' || bytes[kTag.size()] == '/'));
}

/// A scene while it is made.
class SceneAssembly {
 public:
  SceneAssembly(const scene::SceneFile& file, const scene::LoadOptions& options)
      : file_(file),
        options_(options),
        fileHash_(scene::startHash(file.bytes)),
        report_(options.lenient),
        guard_(file.folder, options.allowedPaths),
        description_(readDescription(file, options, guard_, report_)),
        textures_(file, description_, guard_, report_),
        shapes_(file, description_, guard_, textures_, report_, scene_),
        emitters_(file, description_, options, guard_, report_, scene_) {}

  scene::LoadedScene load() {
    const Object& root = *description_.scene;
    for (const Object* const shape : root.nested("shape")) attempt([&] { shapes_.add(*shape); });
    for (const Object* const emitter : root.nested("emitter")) attempt([&] { addEmitter(*emitter); });
    report_.throwIfErrors();
    scene_.images = textures_.takeImages();
    for (const std::string& sentence : scene::shrinkImages(scene_.images)) warn("images " + sentence, sentence);
    const std::optional<scene::Bounds> bounds = scene::boundsOf(scene_);
    addView(bounds);
    scene::setReach(bounds, scene_);
    for (const char* const tag : {"bsdf", "texture", "medium", "sampler", "film", "rfilter"})
      root.nested(tag);  // that objects refer to
    root.reportUnused(report_);
    report_.throwIfErrors();
    return finish(bounds);
  }

 private:
  template <class Action>
  void attempt(const Action& action) {
    if (report_.isFull()) return;
    try {
      action();
    } catch (const PlacedError& error) {
      report_.error(error.place, error.message);
    } catch (const scene::SceneError& error) {
      report_.add(error);
    }
  }

  /// An emitter "area" outside of shapes stands there for shapes that refer to it.
  void addEmitter(const Object& emitter) {
    if (emitter.type == "area" && !emitter.id.empty()) return;
    emitters_.add(emitter);
  }

  void warn(const std::string& kind, const std::string& message) { wholeLog_.warn(kind, {}, message); }

  void addView(const std::optional<scene::Bounds>& bounds) {
    const Object& root = *description_.scene;
    const std::vector<const Object*> sensors = root.nested("sensor");
    const Object* const sensor = chooseSensor(sensors, options_, file_.name);
    if (sensor) attempt([&] { setSensor(*sensor, bounds, report_, scene_); });
    std::string view = "a view that frames the scene";
    if (scene_.camera)
      view = sensor->id.empty() ? sensor->description() : fmt::format("{} \"{}\"", sensor->description(), sensor->id);
    if (!scene_.camera) scene_.camera = scene::framingCamera(bounds);
    facts_.emplace_back("view", view);
    if (sensors.size() > 1) facts_.emplace_back("sensors", std::to_string(sensors.size()));
    const std::vector<const Object*> integrators = root.nested("integrator");
    if (integrators.size() > 1) report_.error(integrators[1]->place, "the scene has a second integrator");
    for (const Object* const integrator : integrators) {
      attempt([&] { facts_.emplace_back("integrator", setIntegrator(*integrator, report_, scene_)); });
    }
  }

  scene::LoadedScene finish(const std::optional<scene::Bounds>& bounds) {
    if (options_.time) warn("time", "the format has no animations");
    if (!report_.omissions().empty())
      warn("omissions", fmt::format("not rendered: {}", fmt::join(report_.omissions(), "; ")));
    scene::warnOfExtent(bounds, wholeLog_);
    scene::warnOfShadows(scene_, wholeLog_);
    if (!scene_.environment) scene::checkScene(scene_, options_, wholeLog_);
    if (!report_.ignored().empty())
      facts_.emplace_back("not used", fmt::format("{}", fmt::join(report_.ignored(), ", ")));
    scene_.name = std::filesystem::path(file_.name).filename().string();
    scene_.hash = hashOfAll();
    std::vector<scene::Diagnostic> warnings = report_.warnings();
    for (scene::Diagnostic& warning : wholeLog_.warnings()) warnings.push_back(std::move(warning));
    return {.scene = std::move(scene_),
            .counts = description_.counts,
            .warnings = std::move(warnings),
            .facts = std::move(facts_),
            .files = guard_.requiredPaths()};
  }

  std::uint64_t hashOfAll() const {
    std::uint64_t hash = fnv1aOfText(fmt::format("{:x}", scene_.hash), fileHash_.get());
    for (const std::string& text : description_.texts) hash = fnv1aOfText(text, hash);
    for (const std::string& definition : options_.definitions) hash = fnv1aOfText(definition + "\n", hash);
    return textures_.hashFiles(shapes_.hashFiles(hash));
  }

  const scene::SceneFile& file_;
  const scene::LoadOptions& options_;
  std::shared_future<std::uint64_t> fileHash_;
  Report report_;
  scene::PathGuard guard_;
  Description description_;
  scene::Scene scene_{};
  scene::DiagnosticLog wholeLog_{file_.name};
  Textures textures_;
  Shapes shapes_;
  Emitters emitters_;
  scene::FileFacts facts_{};
};

scene::LoadedScene loadMitsuba(const scene::SceneFile& file, const scene::LoadOptions& options) {
  return SceneAssembly(file, options).load();
}

std::unique_ptr<scene::SceneReader> openMitsuba(const scene::SceneFile& file, const scene::LoadOptions& options, bool) {
  return scene::readStill(file, options, loadMitsuba);
}

}  // namespace

scene::Loader mitsubaLoader() { return {"Mitsuba", {".xml"}, looksLikeMitsuba, openMitsuba, true}; }

}  // namespace candela::mitsuba
