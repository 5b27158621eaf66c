// Reads scenes, joins requests with options, runs tracers.
#include "host/cli/render_job.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

#include "host/core/errors.h"
#include "host/core/interrupt.h"
#include "host/render/make_renderer.h"
#include "host/scene/load.h"

namespace candela::cli {
namespace {

void requirePixelLimit(const Extent& size) {
  if (std::uint64_t{size.width} * size.height <= kMaximumImagePixels) return;
  throw FileError(fmt::format("an image of {}x{} pixels is beyond the limit of {} pixels", size.width, size.height,
                              kMaximumImagePixels));
}

// The film alone must fit: to ask for more would not fail, but drive the machine into swapping or worse.
void requireMemoryForFilm(const Extent& size) {
  const double needed = static_cast<double>(size.width) * size.height * sizeof(FilmPixel);
  const double present = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed <= present) return;
  constexpr double kGiB = 1024.0 * 1024 * 1024;
  throw OutOfMemoryError(fmt::format("an image of {}x{} pixels needs {:.1f} GiB; this machine has {:.1f} GiB",
                                     size.width, size.height, needed / kGiB, present / kGiB));
}

AccelKind requestedAccel(const Scene& scene) {
  constexpr std::uint32_t kNone = 0;
  constexpr std::uint32_t kGrid = 1;
  if (scene.requestedAccel == kNone) return AccelKind::none;
  if (scene.requestedAccel == kGrid) return AccelKind::grid;
  return AccelKind::bvh;
}

// Options that one integrator alone reads.
struct IntegratorOption {
  const char* option;
  Integrator reader;
  const char* readerName;
};
constexpr std::array kIntegratorOptions{IntegratorOption{"--nee", Integrator::path, "path"},
                                        IntegratorOption{"--rr-start", Integrator::path, "path"},
                                        IntegratorOption{"--light-size", Integrator::whitted, "whitted"}};

// Said rather than refused, so that one command line serves all integrators.
void noteIdleOptions(const Arguments& arguments, const Log& log) {
  for (const auto& [option, reader, readerName] : kIntegratorOptions) {
    if (arguments.settings.integrator == reader || !arguments.given.contains(option)) continue;
    log.note(fmt::format("{} changes nothing here: it is for --integrator {}", option, readerName));
  }
}

}  // namespace

void resolveRequests(Arguments& arguments, const Scene& scene, const Log& log) {
  if (!arguments.sampleCount && scene.requestedSamples) {
    log.detail(fmt::format("{} samples per pixel in total, as the file asks", *scene.requestedSamples));
  }
  if (!arguments.sampleCount) arguments.sampleCount = scene.requestedSamples.value_or(RenderSettings{}.sampleCount);
  if (!arguments.accel) arguments.accel = requestedAccel(scene);
  if (!arguments.maxDepth) arguments.maxDepth = defaultMaxDepth(arguments.settings.integrator);
  if (!arguments.size) arguments.size = Extent{scene.camera->width, scene.camera->height};
  arguments.settings.sampleCount = *arguments.sampleCount;
  arguments.settings.maxDepth = *arguments.maxDepth;
  arguments.settings.accel = *arguments.accel;
  arguments.settings.size = *arguments.size;
}

RenderJob loadJob(const Arguments& arguments, const Log& log) {
  noteIdleOptions(arguments, log);
  const double start = monotonicSeconds();
  LoadedScene loaded = loadScene(arguments.files.front(), {arguments.lenient, arguments.allowedPaths});
  for (const Diagnostic& warning : loaded.warnings) log.warning(toString(warning));
  requireCamera(loaded.scene);
  RenderJob job{arguments, {}, std::move(loaded.scene), 0};
  resolveRequests(job.arguments, job.scene, log);
  job.settings = job.arguments.settings;
  job.parseSeconds = monotonicSeconds() - start;
  requirePixelLimit(job.settings.size);
  requireMemoryForFilm(job.settings.size);
  return job;
}

std::unique_ptr<Renderer> makeRenderer(const std::string& device) {
  return device == "cpu" ? makeReferenceRenderer() : makeGpuRenderer(device);
}

RenderControl makeControl(Progress& progress) {
  RenderControl control;
  control.stop = &watchInterrupts();
  control.progress = [&progress](double fraction, std::uint64_t samples) { progress.update(fraction, samples); };
  return control;
}

void requireComplete(const RenderStatistics& statistics) {
  if (statistics.truncated == 0) return;
  throw InternalError(
      fmt::format("{} loops ended before their work was done, so the image would be wrong; nothing is written. "
                  "A smaller --segments-per-dispatch or another --accel may help",
                  statistics.truncated));
}

}  // namespace candela::cli
