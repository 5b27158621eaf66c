// Reads scenes, combines their settings with options, and creates tracers.
#include "host/cli/render_job.h"

#include <fmt/format.h>

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

}  // namespace

render::RenderSettings resolveRequests(Arguments& arguments, const scene::Scene& scene, const Log& log) {
  if (!arguments.request.sampleCount && scene.requestedSamples) {
    log.detail(fmt::format("{} samples per pixel, as requested by the scene", *scene.requestedSamples));
  }
  render::RenderRequest& request = arguments.request;
  const std::uint32_t sampleCount = render::requestedSampleCount(request, scene);
  render::RenderSettings settings = render::resolve(request, scene);
  request.sampleCount = sampleCount;
  request.size = settings.image.size;
  request.accel = settings.structure.accel;
  request.maxDepth = settings.image.maxDepth;
  job::requirePossible(scene, settings, arguments.film, !arguments.outputs.empty());
  noteIdleOptions(arguments, log);
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
  Arguments complete = arguments;
  if (!arguments.outputs.empty()) complete.film.rescueBeside = arguments.outputs.front();
  render::RenderSettings settings = resolveRequests(complete, *scene, log);
  return {{std::move(scene), complete.loadOptions, std::move(settings), complete.film}, std::move(complete)};
}

RenderJob loadJob(const Arguments& arguments, const Log& log) {
  const double start = monotonicSeconds();
  auto scene = std::make_shared<const scene::Scene>(readScene(arguments, log).scene);
  const double seconds = monotonicSeconds() - start;
  RenderJob job = jobOf(arguments, std::move(scene), log);
  job.parseSeconds = seconds;
  return job;
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
