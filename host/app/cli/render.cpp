// `candela render`: renders a scene file, and writes images and a report.
#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "host/app/cli/adaptive_report.h"
#include "host/app/cli/bad_samples.h"
#include "host/app/cli/commands.h"
#include "host/app/cli/denoise_film.h"
#include "host/app/cli/display_stream.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/render_images.h"
#include "host/app/cli/render_job.h"
#include "host/app/cli/render_sequence.h"
#include "host/app/cli/statistics_report.h"
#include "host/app/cli/text_output.h"
#include "host/base/counted.h"
#include "host/base/errors.h"
#include "host/base/interrupt.h"
#include "host/base/progress.h"
#include "host/base/standard_output.h"
#include "host/trace/render/adaptive_summary.h"

namespace candela::cli {
namespace {

// At most one decimal, and none for whole numbers.
std::string meanSamples(const image::Film& film) {
  return fmt::format("{:g}", std::round(10 * render::sampleCountsOf(film).meanSamples) / 10);
}

std::string doneText(const RenderReport& report, bool isTimeUp) {
  const job::FilmPolicy& film = report.job.film;
  const std::uint32_t total = report.job.settings.image.sampleCount;
  if (report.result.interrupted) {
    return fmt::format("{} after {} of {} per pixel", isTimeUp ? "stopped by --time-limit" : "interrupted",
                       meanSamples(report.result.film), counted(total, "sample"));
  }
  if (film.noiseThreshold) return adaptiveText(report.result.film);
  if (const auto& range = film.samples) {
    return fmt::format("samples {}:{} of {} per pixel", range->first, range->end, total);
  }
  return counted(total, "sample") + " per pixel";
}

void summarise(const RenderReport& report, bool isTimeUp, bool isFrame, const Log& log) {
  const std::string text = fmt::format(
      "{} pixels, {}, {:.2f} s on {}", extentText(report.job.settings.image.window().extent()),
      doneText(report, isTimeUp), report.totalSeconds, report.result.statistics.device);
  if (isFrame) return log.detail(text);
  log.note(text);
}

image::Image imageOf(const RenderJob& job, const RenderArguments& arguments, const render::RenderResult& result,
                     const Log& log) {
  image::Image image = pictureOf(result.film, job.settings.image.hasAlpha(), metadataOf(job, result));
  setPlace(image, job.settings.image.size, job.settings.image.window());
  if (arguments.denoise) denoiseResult(image, result.film, result.interrupted, arguments, log);
  return image;
}

// Returns whether all pictures were written. The render has its report even if one was not.
bool writePictures(const RenderJob& job, const RenderArguments& arguments, const render::RenderResult& result,
                   const Log& log) try {
  if (!arguments.outputs.empty())
    writeImages(imageOf(job, arguments, result, log), arguments, job.settings.image.integrator, log);
  return true;
} catch (const StdoutError& error) {
  // Whoever closed the pipe needs no message.
  if (!isStdoutAbandoned()) log.problem(error.what());
  return false;
} catch (const FileError& error) {
  log.problem(error.what());
  return false;
}

// The name of the image in a display server.
std::string shownName(const RenderJob& job, const RenderArguments& arguments) {
  return arguments.outputs.empty() ? job.scene().name : arguments.outputs.front().filename().string();
}

}  // namespace

ExitCode renderImage(const RenderArguments& arguments, const RenderSteps& steps, const Log& log) {
  const double start = monotonicSeconds();
  for (const auto& file : arguments.outputs) requireWritableImage(file);
  requireLayerFile(arguments);
  requireDenoisable(arguments);
  requireWritableReport(arguments.json);
  const std::optional<film::FilmLock> lock = lockCheckpoint(arguments.film, log);
  // From here on, SIGUSR1 does not end the program, and after the scene has been read, SIGINT and SIGTERM end the
  // render.
  std::atomic<bool>& writeRequested = watchWriteRequests();
  const RenderJob job = steps.load(withDenoiseLayers(arguments));
  requireDenoisable(arguments, job.settings.image);
  if (steps.isDone && steps.isDone(arguments, job)) return ExitCode::done;
  job::JobControl control = steps.control;
  control.stop = &watchInterrupts();
  control.writeRequested = arguments.film.checkpoint.empty() ? nullptr : &writeRequested;
  std::optional<DisplayStream> display;
  if (arguments.displayServer) {
    display.emplace(*arguments.displayServer, shownName(job, arguments), log);
    control.show = [&](const image::Film& film) { display->show(pictureOf(film, job.settings.image.hasAlpha(), {})); };
  }
  const job::JobResult ended = steps.trace(job, control);
  const render::RenderResult& result = ended.result;

  const double writeStart = monotonicSeconds();
  const bool isWanted = !steps.isFrame || !result.interrupted;
  const bool hasPictures = !isWanted || writePictures(job, arguments, result, log);
  const double end = monotonicSeconds();
  RenderReport report{job, result, end - writeStart, end - start, {}, ended.work};
  report.badSamples.add(result.film, job.settings.image);
  reportFlaws(report, log);
  if (arguments.film.checkpoint.empty() && writeRequested) {
    log.warning("SIGUSR1 was ignored: it writes the film of --checkpoint, and this render has none");
  }
  summarise(report, ended.isTimeUp, steps.isFrame, log);
  if (arguments.printStatistics) textStream(arguments.outputs) << toText(report) << std::flush;
  writeJson(arguments.json, toJson(report));
  if (ended.failure) {
    log.problem(ended.failure->message);
    return ended.failure->code;
  }
  if (ended.isFilmLost || !hasPictures) return ExitCode::file;
  const ExitCode code = result.interrupted ? ExitCode::interrupted : ExitCode::done;
  return strictly(code, result.statistics.badSamples, arguments, log);
}

ExitCode run(const RenderArguments& arguments, const Log& log) {
  if (arguments.isSequence()) return renderSequence(arguments, log);
  RenderSteps steps;
  steps.control.line = progressStyle(log.verbosity());
  steps.load = [&](const RenderArguments& one) { return loadJob(one, log); };
  steps.trace = [&](const RenderJob& job, const job::JobControl& control) {
    return job::runJob(job, openDevice(job.arguments, log), control, log);
  };
  return renderImage(arguments, steps, log);
}

}  // namespace candela::cli
