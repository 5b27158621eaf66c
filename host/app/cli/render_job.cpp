// Reads scenes, combines their settings with options, and creates tracers.
#include "host/app/cli/render_job.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/cli/idle_options.h"
#include "host/app/cli/separate_files.h"
#include "host/app/cli/tuned.h"
#include "host/base/interrupt.h"
#include "host/formats/load_scene.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/reference/reference_renderer.h"
#include "host/trace/render/request.h"
#include "host/trace/vulkan/device.h"

namespace candela::cli {
namespace {

void warnOfDarkness(const render::RenderSettings& settings, const scene::Scene& scene, const Log& log) {
  if (settings.image.integrator != render::Integrator::whitted || !scene.pointLights.empty()) return;
  log.warning(
      "the scene has no point light, and --integrator whitted ignores all other lights: surfaces show only their own "
      "emission");
}

const TracingArguments& tracingOf(const TracingCommand& command) {
  return std::visit([](const TracingArguments& arguments) -> const TracingArguments& { return arguments; }, command);
}

// All commands but `render` use the reference tracer, too, and show images.
OptionUse useOf(const TracingCommand& command, const render::RenderSettings& settings) {
  const TracingArguments& arguments = tracingOf(command);
  OptionUse use{arguments, settings, !arguments.usesReference()};
  use.choosesLayers = std::holds_alternative<ViewArguments>(command);
  const auto* const render = std::get_if<RenderArguments>(&command);
  if (render == nullptr) return use;
  use.onReference = render->usesReference() || render->film.fallback == job::Fallback::reference;
  use.showsImages = std::ranges::any_of(render->outputs, image::isEightBit);
  return use;
}

job::FilmPolicy filmPolicyOf(const RenderArguments& arguments) {
  job::FilmPolicy film = arguments.film;
  if (!arguments.outputs.empty()) film.rescueBeside = arguments.outputs.front();
  return film;
}

}  // namespace

render::RenderSettings resolveRequest(const render::RenderRequest& request, const scene::Scene& scene,
                                      const job::FilmPolicy& film, bool makesPictures, const Log& log) {
  if (!request.sampleCount && scene.requestedSamples) {
    log.detail(fmt::format("{} samples per pixel, as requested by the scene", *scene.requestedSamples));
  }
  render::RenderSettings settings = render::resolve(request, scene);
  job::requirePossible(scene, settings, film, makesPictures);
  if (settings.image.crop && !request.crop) {
    log.detail(fmt::format("the crop {}, as requested by the scene", windowText(*settings.image.crop)));
  }
  return settings;
}

void acceptScene(const scene::LoadedScene& loaded, const Arguments& command, const Log& log) {
  for (const scene::Diagnostic& warning : loaded.warnings) log.warning(toString(warning));
  requireUnread(command, loaded.files);
  requireCamera(loaded.scene);
}

scene::LoadedScene readScene(const Arguments& command, const Log& log) {
  const auto& arguments = partOf<SceneArguments>(command);
  scene::LoadedScene loaded = formats::loadScene(arguments.files.front(), arguments.loadOptions);
  acceptScene(loaded, command, log);
  return loaded;
}

RenderJob jobOf(const TracingCommand& command, std::shared_ptr<const scene::Scene> scene, const Log& log) {
  const TracingArguments& arguments = tracingOf(command);
  const auto* const render = std::get_if<RenderArguments>(&command);
  const job::FilmPolicy film = render != nullptr ? filmPolicyOf(*render) : job::FilmPolicy();
  const bool makesPictures = render != nullptr && !render->outputs.empty();
  // Other commands than `render` judge, measure and show whole images.
  const render::RenderRequest request = render != nullptr ? arguments.request
                                                          : withoutSceneCrop(arguments.request, *scene);
  const render::RenderSettings settings = resolveRequest(request, *scene, film, makesPictures, log);
  // Benchmarks choose the structures themselves.
  if (!std::holds_alternative<BenchArguments>(command)) noteIdleOptions(useOf(command, settings), log);
  if (render != nullptr) noteLostAlpha(*render, log);
  warnOfDarkness(settings, *scene, log);
  return {{std::move(scene), arguments.loadOptions, settings, film}, arguments};
}

RenderJob loadJob(const TracingCommand& command, const Log& log) {
  const double start = monotonicSeconds();
  const Arguments arguments = std::visit([](const auto& one) { return Arguments(one); }, command);
  auto scene = std::make_shared<const scene::Scene>(readScene(arguments, log).scene);
  const double seconds = monotonicSeconds() - start;
  RenderJob job = jobOf(command, std::move(scene), log);
  job.parseSeconds = seconds;
  return job;
}

RenderArguments statedArguments(const RenderJob& job) {
  RenderArguments stated;
  static_cast<TracingArguments&>(stated) = job.arguments;
  stated.request = render::requestOf(job.settings);
  stated.request.filmScale = job.arguments.request.filmScale;
  stated.film = job.film;
  return stated;
}

std::unique_ptr<render::Renderer> makeRenderer(const TracingArguments& arguments, const Log& log) {
  if (arguments.usesReference()) return reference::makeReferenceRenderer();
  auto cached = std::make_unique<CachedDevice>(arguments, log);
  render::AutomaticChoices choices = automaticChoices(arguments, cached->device().info(), log);
  return std::make_unique<TunedRenderer>(std::move(cached), std::move(choices), log);
}

job::OpenDevice openDevice(const TracingArguments& arguments, const Log& log) {
  if (arguments.usesReference()) return {};
  return [&arguments, &log] { return makeRenderer(arguments, log); };
}

render::RenderControl makeControl(Progress& progress) {
  render::RenderControl control;
  control.stop = &watchInterrupts();
  control.progress = [&progress](double fraction, std::uint64_t samples) { progress.update(fraction, samples); };
  return control;
}

}  // namespace candela::cli
