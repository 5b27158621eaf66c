// `candela render`: renders a scene file, and writes images and a report.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/cli/bad_samples.h"
#include "host/cli/bias_text.h"
#include "host/cli/commands.h"
#include "host/cli/display_choice.h"
#include "host/cli/json_output.h"
#include "host/cli/option_table.h"
#include "host/cli/output_check.h"
#include "host/cli/render_job.h"
#include "host/cli/statistics_report.h"
#include "host/cli/trace_film.h"
#include "host/core/hash_text.h"
#include "host/core/interrupt.h"
#include "host/core/progress.h"
#include "host/core/version.h"
#include "host/image/false_colour.h"
#include "host/verify/film_test.h"

namespace candela::cli {
namespace {

// Returns the metadata of an image file, which describe how it was rendered.
std::map<std::string, std::string> imageMetadata(const RenderJob& job, const render::RenderResult& result) {
  const render::RenderStatistics& statistics = result.statistics;
  std::string settings = commandLineOf(job.arguments, OptionGroup::image, false);
  const std::string reading = commandLineOf(job.arguments, OptionGroup::sceneFile, true);
  if (!reading.empty()) settings += " " + reading;
  std::map<std::string, std::string> metadata{
      {"candela.version", versionText()},
      {"candela.scene", job.scene.name},
      {"candela.sceneHash", hashText(job.scene.hash)},
      {"candela.filmHash", hashText(result.film.hash())},
      {"candela.samplesPerPixel", fmt::to_string(job.settings.image.sampleCount)},
      {verify::kSeedMetadata, fmt::to_string(job.settings.image.seed)},
      {"candela.device", statistics.device},
      {"candela.driver", statistics.driver},
      {"candela.settings", settings},
      {"candela.interrupted", result.interrupted ? "yes" : "no"}};
  if (job.settings.image.crop) metadata["candela.crop"] = windowText(*job.settings.image.crop);
  if (job.arguments.samples) {
    metadata["candela.samples"] = fmt::format("{}:{}", job.arguments.samples->first, job.arguments.samples->end);
  }
  if (job.settings.image.indirectLimit) metadata[verify::kBiasMetadata] = biasText(*job.settings.image.indirectLimit);
  return metadata;
}

void writeImages(const RenderJob& job, const render::RenderResult& result, const Log& log) {
  if (job.arguments.outputs.empty()) return;
  image::Image image = toImage(result.film);
  if (job.settings.image.hasAlpha()) addAlpha(image, result.film);
  addLayers(image, result.film);
  image.metadata.merge(imageMetadata(job, result));
  const image::DisplayTransform display = chooseDisplay(job.arguments, image);
  if (isFalseColour(display.toneMap)) {
    image.metadata["candela.falseColour"] = falseColourText(display);
    if (std::any_of(job.arguments.outputs.begin(), job.arguments.outputs.end(), image::isEightBit)) {
      log.note(falseColourKey(display));
    }
  }
  for (const auto& file : job.arguments.outputs) writeImage(file, image, display);
}

void summarise(const RenderReport& report, const Log& log) {
  const render::RenderSettings& settings = report.job.settings;
  const std::string done = report.result.interrupted
                               ? fmt::format("interrupted; the {} samples rendered so far are written",
                                             report.result.statistics.samples)
                               : fmt::format("{} samples per pixel", settings.image.sampleCount);
  log.note(fmt::format("{} pixels, {}, {:.2f} s on {}", extentText(settings.image.window().extent()), done,
                       report.totalSeconds, report.result.statistics.device));
}

// A film file is work that is not to be lost: only the render that goes on from it may replace it.
void requireCheckpoint(const Arguments& arguments) {
  const std::filesystem::path& file = arguments.checkpoint;
  if (file.empty()) return;
  requireWritableFile(file);
  watchWriteRequests();  // from here on, SIGUSR1 does not end the program
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    throw FileError(fmt::format("{}: a film is written to a regular file only", file.string()));
  }
  if (!arguments.resume.empty() && std::filesystem::equivalent(file, arguments.resume, ignored)) return;
  throw FileError(
      fmt::format("{}: the file exists, and its samples would be lost; go on from it with --resume {}, or "
                  "remove it",
                  file.string(), file.string()));
}

}  // namespace

ExitCode runRender(const Arguments& arguments, const Log& log) {
  const double start = monotonicSeconds();
  for (const auto& file : arguments.outputs) requireWritableImage(file);
  requireLayerFile(arguments);
  requireWritableReport(arguments.json);
  requireCheckpoint(arguments);
  const RenderJob job = loadJob(arguments, log);
  const TracedFilm traced = traceFilm(job, start, log);
  const render::RenderResult& result = traced.result;

  const double writeStart = monotonicSeconds();
  writeImages(job, result, log);
  const double end = monotonicSeconds();
  RenderReport report{job, result, end - writeStart, end - start, {}, traced.work};
  report.badSamples.add(result.film, job.settings.image);
  for (const std::string& line : badSampleLines(report.badSamples, job)) log.problem(line);
  if (const std::uint64_t faults = result.statistics.volumeFaults; faults > 0) {
    log.warning(fmt::format("{} rays found volumes that are open or overlap; absorption is wrong there", faults));
  }
  summarise(report, log);
  if (arguments.printStatistics) std::cout << toText(report) << std::flush;
  writeJson(arguments.json, toJson(report));
  if (traced.failure) {
    log.problem(traced.failure->message);
    return traced.failure->code;
  }
  if (traced.isFilmLost) return ExitCode::file;
  const ExitCode code = result.interrupted ? ExitCode::interrupted : ExitCode::done;
  return strictly(code, result.statistics.badSamples, arguments, log);
}

}  // namespace candela::cli
