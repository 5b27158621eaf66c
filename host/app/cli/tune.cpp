// `candela tune`: finds the fastest settings of a device, and stores them for later commands.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/bench_output.h"
#include "host/app/cli/cached_device.h"
#include "host/app/cli/commands.h"
#include "host/app/cli/idle_options.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/render_job.h"
#include "host/base/counted.h"
#include "host/base/interrupt.h"
#include "host/base/progress.h"
#include "host/drivers/doctor/resources.h"
#include "host/job/cache/cache_folder.h"
#include "host/measure/tune/tune_report.h"
#include "host/measure/tune/tuning_file.h"
#include "host/measure/tune/work.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/vulkan/device.h"

namespace candela::cli {
namespace {

using tune::TuneReport;
using tune::Work;

// Returns the file for the result. Throws FileError if it cannot be written.
std::filesystem::path requireFile(const cache::DeviceKey& key) {
  const std::optional<std::filesystem::path> folder = cache::cacheFolder();
  if (!folder) {
    throw FileError("no folder for the result: set HOME, XDG_CACHE_HOME or CANDELA_CACHE_DIR, or use --dry-run");
  }
  if (const std::string problem = doctor::whyNotWritable(*folder); !problem.empty()) {
    throw FileError(fmt::format("{}: the result cannot be stored: {}; set CANDELA_CACHE_DIR, or use --dry-run",
                                folder->string(), problem));
  }
  const std::filesystem::path file = *folder / cache::fileNameOf("tune", key, "json");
  tune::requireTuningFile(file);
  return file;
}

Work workOf(const TuneArguments& arguments, scene::Scene scene, const Log& log) {
  render::RenderRequest request;
  request.sampleCount = arguments.sampleCount;
  request.size = arguments.size;
  render::RenderSettings settings = resolveRequest(withoutSceneCrop(request, scene), scene, {}, false, log);
  noteIdleOptions({arguments, settings}, log);
  return {std::move(scene), std::move(settings)};
}

std::vector<Work> worksOf(const TuneArguments& arguments, const Log& log) {
  std::vector<Work> works;
  for (const std::string& file : arguments.files) {
    TuneArguments one = arguments;
    one.files = {file};
    works.push_back(workOf(one, readScene(one, log).scene, log));
  }
  if (!works.empty()) return works;
  for (scene::Scene& scene : tune::builtInScenes()) works.push_back(workOf(arguments, std::move(scene), log));
  return works;
}

tune::SearchResult measure(const TuneArguments& arguments, vulkan::Device& device, std::vector<Work>& works,
                           const Log& log) {
  const std::unique_ptr<render::Renderer> renderer = device::makeGpuRenderer(device);
  render::RenderControl control;
  control.stop = &watchInterrupts();
  for (Work& work : works) {
    fitToDevice(*renderer, {arguments.size, arguments.sampleCount}, control, work);
    log.note(fmt::format("{}: {} pixels, {} per pixel", work.scene.name, extentText(work.settings.image.size),
                         counted(work.settings.image.sampleCount, "sample")));
  }
  return tune::search(device.info(), arguments.repeats,
                      [&](std::span<const tune::Candidate> candidates, std::uint32_t repeats) {
                        log.note(fmt::format("{}, {} of each on {}", counted(candidates.size(), "candidate"),
                                             counted(repeats, "run"), counted(works.size(), "scene")));
                        Progress progress(std::cerr, progressStyle(log.verbosity()));
                        return tune::measureWork(*renderer, works, candidates, repeats, makeControl(progress));
                      });
}

// Returns false if the file cannot be written. The measurements are published nevertheless.
bool store(const cache::DeviceKey& key, TuneReport& report, const Log& log) {
  if (!report.file) return true;
  try {
    tune::writeTuning(*report.file, key, {report.result.chosen, tune::dateNow()});
    return true;
  } catch (const FileError& error) {
    log.problem(error.what());
    report.file.reset();
    return false;
  }
}

}  // namespace

ExitCode run(const TuneArguments& arguments, const Log& log) {
  if (arguments.usesReference()) {
    throw UsageError(
        "tune --device cpu: the reference tracer has nothing to tune; choose a Vulkan device (see candela devices)");
  }
  watchInterrupts();
  for (const std::string& target : {arguments.json, arguments.markdown}) requireWritableReport(target);
  CachedDevice cached(arguments, log);
  vulkan::Device& device = cached.device();
  const cache::DeviceKey key = cache::keyOf(device.info());
  TuneReport report;
  if (!arguments.dryRun) report.file = requireFile(key);
  std::vector<Work> works = worksOf(arguments, log);
  report.repeats = arguments.repeats;
  report.result = measure(arguments, device, works, log);
  if (!report.result.builtInAgrees) report.file.reset();
  const bool isStored = store(key, report, log);
  const ExitCode code = publish(report, arguments, log,
                                "the images of some candidates differ; find the wrong ones with `candela verify`");
  return isStored ? code : ExitCode::file;
}

}  // namespace candela::cli
