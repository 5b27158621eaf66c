// Reads scenes, combines their settings with options, and creates tracers.
#include "host/cli/render_job.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/cli/idle_options.h"
#include "host/cli/separate_files.h"
#include "host/cli/tuned.h"
#include "host/core/interrupt.h"
#include "host/device/gpu_renderer.h"
#include "host/formats/load_scene.h"
#include "host/reference/reference_renderer.h"
#include "host/render/request.h"
#include "host/vulkan/device.h"

namespace candela::cli {
namespace {

void warnOfDarkness(const render::RenderSettings& settings, const scene::Scene& scene, const Log& log) {
  if (settings.image.integrator != render::Integrator::whitted || !scene.pointLights.empty()) return;
  log.warning(
      "the scene has no point light, and --integrator whitted ignores all other lights: surfaces show only their own "
      "emission");
}

// All commands but `render` use the reference tracer, too, and show images.
OptionUse useOf(const Arguments& arguments, const render::RenderSettings& settings) {
  OptionUse use{arguments, settings, !arguments.usesReference()};
  use.choosesLayers = arguments.command == Command::view;
  if (arguments.command != Command::render) return use;
  use.onReference = arguments.usesReference() || arguments.film.fallback == job::Fallback::reference;
  use.showsImages = std::ranges::any_of(arguments.outputs, image::isEightBit);
  return use;
}

}  // namespace

render::RenderSettings resolveRequests(const Arguments& arguments, const scene::Scene& scene, const Log& log) {
  if (!arguments.request.sampleCount && scene.requestedSamples) {
    log.detail(fmt::format("{} samples per pixel, as requested by the scene", *scene.requestedSamples));
  }
  render::RenderSettings settings = render::resolve(arguments.request, scene);
  job::requirePossible(scene, settings, arguments.film, !arguments.outputs.empty());
  // Benchmarks choose the structures themselves.
  if (arguments.command != Command::bench) noteIdleOptions(useOf(arguments, settings), log);
  noteLostAlpha(arguments, log);
  warnOfDarkness(settings, scene, log);
  return settings;
}

scene::LoadedScene readScene(const Arguments& arguments, const Log& log) {
  scene::LoadedScene loaded = formats::loadScene(arguments.files.front(), arguments.loadOptions);
  for (const scene::Diagnostic& warning : loaded.warnings) log.warning(toString(warning));
  requireUnread(arguments, loaded.files);
  requireCamera(loaded.scene);
  return loaded;
}

RenderJob jobOf(const Arguments& arguments, std::shared_ptr<const scene::Scene> scene, const Log& log) {
  job::FilmPolicy film = arguments.film;
  if (!arguments.outputs.empty()) film.rescueBeside = arguments.outputs.front();
  render::RenderSettings settings = resolveRequests(arguments, *scene, log);
  return {{std::move(scene), arguments.loadOptions, std::move(settings), std::move(film)}, arguments};
}

RenderJob loadJob(const Arguments& arguments, const Log& log) {
  const double start = monotonicSeconds();
  auto scene = std::make_shared<const scene::Scene>(readScene(arguments, log).scene);
  const double seconds = monotonicSeconds() - start;
  RenderJob job = jobOf(arguments, std::move(scene), log);
  job.parseSeconds = seconds;
  return job;
}

Arguments statedArguments(const RenderJob& job) {
  Arguments stated = job.arguments;
  stated.request = render::requestOf(job.settings);
  stated.request.filmScale = job.arguments.request.filmScale;
  stated.film = job.film;
  return stated;
}

std::unique_ptr<render::Renderer> makeRenderer(const Arguments& arguments, const Log& log) {
  if (arguments.usesReference()) return reference::makeReferenceRenderer();
  auto cached = std::make_unique<CachedDevice>(arguments, log);
  render::AutomaticChoices choices = automaticChoices(arguments, cached->device().info(), log);
  return std::make_unique<TunedRenderer>(std::move(cached), std::move(choices), log);
}

job::OpenDevice openDevice(const Arguments& arguments, const Log& log) {
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
