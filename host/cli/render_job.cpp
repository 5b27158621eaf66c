// Reads scenes, combines their settings with options, and creates tracers.
#include "host/cli/render_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/cli/adaptive_report.h"
#include "host/cli/memory_check.h"
#include "host/cli/separate_files.h"
#include "host/cli/tuned.h"
#include "host/core/errors.h"
#include "host/core/file_extension.h"
#include "host/core/interrupt.h"
#include "host/device/gpu_renderer.h"
#include "host/device/kernel.h"
#include "host/formats/load_scene.h"
#include "host/reference/reference_renderer.h"
#include "host/render/request.h"
#include "host/vulkan/device.h"

namespace candela::cli {
namespace {

void requirePixelLimit(const render::Extent& size) {
  if (std::uint64_t{size.width} * size.height <= image::kMaxImagePixels) return;
  throw FileError(fmt::format("an image of {}x{} pixels exceeds the limit of {} pixels", size.width, size.height,
                              image::kMaxImagePixels));
}

void requireCropWithin(const render::ImageSettings& image) {
  if (!image.crop || isWithin(*image.crop, image.size)) return;
  throw UsageError(
      fmt::format("--crop {} is not within the image of {} pixels", windowText(*image.crop), extentText(image.size)));
}

bool usesIntegrator(const Arguments& arguments, render::Integrator integrator) {
  return arguments.request.settings.image.integrator == integrator;
}

bool usesAccel(const Arguments& arguments, render::AccelKind accel) {
  return arguments.request.settings.structure.accel == accel;
}

bool usesEnvironment(const Arguments& arguments) { return !arguments.loadOptions.environment.source.empty(); }

bool usesDevice(const Arguments& arguments) { return !arguments.usesReference(); }

// All commands but `render` use the reference tracer, too.
bool usesReferenceThreads(const Arguments& arguments) {
  return arguments.usesReference() || arguments.command != Command::render || arguments.fallback == Fallback::reference;
}

bool buildsDeviceBvh(const Arguments& arguments) {
  return usesDevice(arguments) && usesAccel(arguments, render::AccelKind::bvh);
}

// Comparisons and the viewer display images as well.
bool displaysImage(const Arguments& arguments) {
  return arguments.command != Command::render || std::ranges::any_of(arguments.outputs, image::isEightBit);
}

bool hasAlphaChannel(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  return extension == ".png" || extension == ".exr";
}

// Options that have an effect only on some renders.
struct SpecialOption {
  const char* option;
  bool (*isRead)(const Arguments& arguments);
  const char* reader;
};
constexpr const char* kDeviceReader = "Vulkan devices";
constexpr std::array kSpecialOptions{
    SpecialOption{"--nee", [](const Arguments& a) { return usesIntegrator(a, render::Integrator::path); },
                  "--integrator path"},
    SpecialOption{"--rr-start", [](const Arguments& a) { return usesIntegrator(a, render::Integrator::path); },
                  "--integrator path"},
    SpecialOption{"--aov-through-specular",
                  [](const Arguments& a) {
                    const bool mayShowLayers = a.command == Command::view;  // they are chosen in the window
                    return mayShowLayers || !withSums(a.request.settings.image.layers).isEmpty();
                  },
                  "renders with --aov or --denoise"},
    SpecialOption{"--max-depth", [](const Arguments& a) { return !isView(a.request.settings.image.integrator); },
                  "--integrator path or whitted"},
    SpecialOption{"--light-size", [](const Arguments& a) { return usesIntegrator(a, render::Integrator::whitted); },
                  "--integrator whitted"},
    SpecialOption{"--ao-distance", [](const Arguments& a) { return usesIntegrator(a, render::Integrator::ao); },
                  "--integrator ao"},
    SpecialOption{"--grid-density", [](const Arguments& a) { return usesAccel(a, render::AccelKind::grid); },
                  "--accel grid"},
    SpecialOption{"--layout", buildsDeviceBvh, "Vulkan devices with --accel bvh"},
    SpecialOption{"--bvh-split", [](const Arguments& a) { return usesAccel(a, render::AccelKind::bvh); },
                  "--accel bvh"},
    SpecialOption{"--bvh-quality",
                  [](const Arguments& a) {
                    return buildsDeviceBvh(a) && a.request.settings.structure.bvhSplit == render::BvhSplit::sah;
                  },
                  "Vulkan devices with --accel bvh and --bvh-split sah"},
    SpecialOption{"--kernel",
                  [](const Arguments& a) { return usesDevice(a) && usesIntegrator(a, render::Integrator::path); },
                  "Vulkan devices with --integrator path"},
    SpecialOption{"--loads", usesDevice, kDeviceReader},
    SpecialOption{"--workgroup", usesDevice, kDeviceReader},
    SpecialOption{"--segments-per-dispatch", usesDevice, kDeviceReader},
    SpecialOption{"--hang-timeout", usesDevice, kDeviceReader},
    SpecialOption{"--fallback", usesDevice, kDeviceReader},
    SpecialOption{"--threads", usesReferenceThreads, "the reference tracer (--device cpu)"},
    SpecialOption{"--env-rotate", usesEnvironment, "the environment of --env"},
    SpecialOption{"--env-scale", usesEnvironment, "the environment of --env"},
    SpecialOption{"--tonemap", displaysImage, "PNG and JPEG files"},
    SpecialOption{"--exposure", displaysImage, "PNG and JPEG files"}};

// Such options cause a note rather than an error, so that one command line can be used for all renders.
void noteIdleOptions(const Arguments& arguments, const Log& log) {
  if (arguments.command == Command::bench) return;  // benchmarks choose the structures themselves
  for (const auto& [option, isRead, reader] : kSpecialOptions) {
    if (isRead(arguments) || !arguments.given.contains(option)) continue;
    log.note(fmt::format("{} has no effect here; it applies to {}", option, reader));
  }
}

void noteLostAlpha(const Arguments& arguments, const Log& log) {
  const bool hasOther = arguments.outputs.empty() || !arguments.checkpoint.empty() || arguments.displayServer;
  if (arguments.request.settings.image.backdrop != render::Backdrop::none || hasOther) return;
  if (std::ranges::any_of(arguments.outputs, hasAlphaChannel)) return;
  log.note(
      "--background none: JPEG, HDR and PFM files have no alpha, so that the background is black in them; write a "
      "PNG or EXR file");
}

void warnOfDarkness(const render::RenderSettings& settings, const scene::Scene& scene, const Log& log) {
  if (settings.image.integrator != render::Integrator::whitted || !scene.pointLights.empty()) return;
  log.warning(
      "the scene has no point light, and --integrator whitted ignores all other lights: surfaces show only their own "
      "emission");
}

}  // namespace

void resolveRequests(Arguments& arguments, const scene::Scene& scene, const Log& log) {
  if (!arguments.request.sampleCount && scene.requestedSamples) {
    log.detail(fmt::format("{} samples per pixel, as requested by the scene", *scene.requestedSamples));
  }
  render::RenderRequest& request = arguments.request;
  const std::uint32_t sampleCount = render::requestedSampleCount(request, scene);
  request.settings = render::resolve(request, scene);
  request.sampleCount = sampleCount;
  request.size = request.settings.image.size;
  request.accel = request.settings.structure.accel;
  request.maxDepth = request.settings.image.maxDepth;
}

void requirePossible(const Arguments& arguments, const scene::Scene& scene, const Log& log) {
  device::requireKernel(arguments.request.settings);
  render::requireIntegrator(scene, arguments.request.settings);
  requirePixelLimit(arguments.request.settings.image.size);
  requireCropWithin(arguments.request.settings.image);
  requireAdaptable(arguments);
  requireMemoryForRender(scene, arguments);
  noteIdleOptions(arguments, log);
  noteLostAlpha(arguments, log);
  warnOfDarkness(arguments.request.settings, scene, log);
}

scene::LoadedScene readScene(const Arguments& arguments, const Log& log) {
  scene::LoadedScene loaded = formats::loadScene(arguments.files.front(), arguments.loadOptions);
  for (const scene::Diagnostic& warning : loaded.warnings) log.warning(toString(warning));
  requireUnread(arguments, loaded.files);
  requireCamera(loaded.scene);
  return loaded;
}

RenderJob jobOf(const Arguments& arguments, std::shared_ptr<const scene::Scene> scene, const Log& log) {
  RenderJob job{arguments, std::move(scene)};
  resolveRequests(job.arguments, job.scene, log);
  requirePossible(job.arguments, job.scene, log);
  return job;
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

render::RenderControl makeControl(Progress& progress) {
  render::RenderControl control;
  control.stop = &watchInterrupts();
  control.progress = [&progress](double fraction, std::uint64_t samples) { progress.update(fraction, samples); };
  return control;
}

}  // namespace candela::cli
