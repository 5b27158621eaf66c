// Opens devices, reads scenes again when they change, and saves the image of the window.
#include "host/app/cli/viewed_scene.h"

#include "host/app/cli/render_images.h"
#include "host/app/cli/separate_files.h"
#include "host/app/cli/tuned.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/reference/reference_renderer.h"
#include "host/trace/render/film_coverage.h"

namespace candela::cli {
namespace {

constexpr std::uint32_t kDefaultSamples = 4096;
constexpr double kDispatchSeconds = 0.015;  // so that input is answered soon
constexpr render::Extent kWarmUpSize{8, 8};

ViewArguments withChoice(ViewArguments arguments, const view::Choice& choice) {
  arguments.device = choice.device;
  arguments.loadOptions.time = choice.time;
  image::LayerSet& layers = arguments.request.image.layers;
  layers.bits |= view::neededBy(choice.layer).bits;
  // Another integrator than that of the command line was chosen in the window. Only the path tracer has layers.
  if (choice.integrator != arguments.request.image.integrator && choice.integrator != render::Integrator::path)
    layers = {};
  arguments.request.image.integrator = choice.integrator;
  arguments.request.execution.dispatchSeconds = kDispatchSeconds;
  if (!arguments.request.sampleCount) arguments.request.sampleCount = kDefaultSamples;
  return arguments;
}

// Returns whether a pixel lacks samples.
bool isPartial(const image::Film& film, const RenderJob& job) {
  return render::minSampleCount(film.pixels()) < job.settings.image.sampleCount;
}

// Writes the colours of a layer, which an 8-bit file has instead of the picture.
void writeLayer(const std::filesystem::path& file, const image::Film& film, image::Layer layer,
                const image::DisplayTransform& display, std::uint32_t sampleCount) {
  view::Picture picture({film.width(), film.height()});
  showLayer(film, layer, picture);
  const view::LayerColours colours = view::coloursOf(layer, display, view::rangeOf(picture), sampleCount);
  image::Image image = toImage(film);
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = view::exposed(glm::vec3(picture.pixels[i]), colours);
  writeImage(file, image, {colours.toneMap, 0, colours.scale});
}

}  // namespace

RenderJob ViewedScene::job(const view::Choice& choice, bool reads) {
  const ViewArguments arguments = withChoice(arguments_, choice);
  const std::scoped_lock lock(mutex_);
  if (reads || !scene_ || time_ != choice.time) makeScene(choice, reads);
  return jobOf(arguments, scene_, log_);
}

view::Sessions ViewedScene::load(const view::Choice& choice, bool reads) {
  const RenderJob job = this->job(choice, reads);
  view::Sessions sessions{job.sharedScene, job.settings, animationEnd_};
  sessions.reference = reference::makeReferenceRenderer()->prepare(*sessions.scene, sessions.settings);
  return sessions;
}

vulkan::Device ViewedScene::open(const view::Choice& choice, const std::vector<std::string>& windowExtensions) {
  OpenedDevice& opened = devices_[choice.device];
  if (!opened.device) {
    opened.device = std::make_unique<CachedDevice>(withChoice(arguments_, choice), log_, windowExtensions);
    opened.renderer = device::makeGpuRenderer(opened.device->device());
  }
  return opened.device->device();
}

// Runs of one device must not overlap, and preparations that are not wanted any more may still be under way.
void ViewedScene::addDevice(const view::Choice& choice, view::Sessions& sessions) {
  const std::scoped_lock lock(deviceMutex_);
  const vulkan::Device device = open(choice);
  render::RenderSettings settings = sessions.settings;
  settings.execution.automatic = automaticChoices(arguments_, device.info(), log_);
  sessions.device = devices_[choice.device].renderer->prepare(*sessions.scene, settings);
  sessions.device->setView(*sessions.scene->camera, kWarmUpSize);
  sessions.device->advance({0, 1}, {});
  sessions.deviceName = device.info().name;
}

void ViewedScene::save(const std::filesystem::path& file, const view::Sessions& sessions, const scene::Camera& camera,
                       const image::Film& film, const render::RenderStatistics& statistics, const view::Choice& choice,
                       const image::DisplayTransform& display) {
  requireSavable(file);
  render::requireComplete(statistics);
  const RenderJob job = jobOf(withChoice(arguments_, choice), sessions.scene, log_);
  Metadata metadata = metadataOf(job, {film, statistics, isPartial(film, job), {}});
  addMovedCamera(camera, *sessions.scene->camera, metadata);
  const image::Image image = pictureOf(film, job.settings.image.hasAlpha(), std::move(metadata));
  if (choice.layer && image::isEightBit(file))
    return writeLayer(file, film, *choice.layer, display, job.settings.image.sampleCount);
  writeImage(file, image, display);
}

void ViewedScene::makeScene(const view::Choice& choice, bool reads) {
  std::unique_ptr<formats::SceneSource> source = std::move(source_);
  if (reads || !source) {
    source = std::make_unique<formats::SceneSource>(arguments_.files.front(), arguments_.loadOptions);
  }
  scene::LoadedScene loaded = source->at(choice.time, arguments_.loadOptions.orbit);
  for (const scene::Diagnostic& warning : loaded.warnings) {
    if (warnings_.insert(toString(warning)).second || reads) log_.warning(toString(warning));
  }
  requireUnread(arguments_, loaded.files);
  requireCamera(loaded.scene);
  source_ = loaded.animationEnd ? std::move(source) : nullptr;  // without an animation, all times are the same
  scene_ = std::make_shared<const scene::Scene>(std::move(loaded.scene));
  time_ = choice.time;
  animationEnd_ = loaded.animationEnd;
  files_.insert(loaded.files.begin(), loaded.files.end());
}

// The file is named in the window, so that no check of the command line has seen it.
void ViewedScene::requireSavable(const std::filesystem::path& file) {
  image::checkImageFormat(file);
  RenderArguments saving;  // as a render would write it
  saving.files = arguments_.files;
  saving.json = arguments_.json;
  saving.outputs = {file};
  const std::scoped_lock lock(mutex_);
  requireSeparateFiles(saving);
  requireUnread(saving, {files_.begin(), files_.end()});
}

}  // namespace candela::cli
