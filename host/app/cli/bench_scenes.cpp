// `candela bench SCENE...`: times whole renders, with every combination of the swept options.
#include <fmt/format.h>
#include <sys/resource.h>

#include <iostream>

#include "host/app/cli/bench_output.h"
#include "host/app/cli/commands.h"
#include "host/app/cli/option_table.h"
#include "host/app/cli/render_job.h"
#include "host/app/cli/sweep.h"
#include "host/base/counted.h"
#include "host/base/errors.h"
#include "host/base/progress.h"
#include "host/measure/bench/sweep_report.h"

namespace candela::cli {
namespace {

using bench::Measurement;
using bench::SweepReport;
using bench::Variant;

std::uint64_t peakProcessBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

// The film depends only on the options of the image group.
std::vector<Variant> variantsOf(const RenderJob& job, const std::vector<SweptArguments>& sweeps, const Log& log) {
  std::vector<Variant> variants;
  for (const SweptArguments& swept : sweeps) {
    const RenderJob variant = jobOf(swept.arguments, job.sharedScene, log);
    variants.push_back(
        {swept.name, variant.settings, commandLineOf(statedArguments(variant), OptionGroup::image, false)});
  }
  return variants;
}

// Returns false if it was interrupted.
bool measureScene(const BenchArguments& arguments, render::Renderer& renderer, const Log& log, SweepReport& report) {
  const RenderJob job = loadJob(arguments, log);
  const std::vector<Variant> variants = variantsOf(job, sweepOver(arguments), log);
  log.note(fmt::format("{}: {}, runs of each: {}", job.scene().name, counted(variants.size(), "variant"),
                       arguments.repeats));
  Progress progress(std::cerr, progressStyle(log.verbosity()));
  const render::RenderControl control = makeControl(progress);
  std::vector<Measurement> measurements = bench::measureInterleaved(renderer, job.scene(), variants, arguments.repeats,
                                                                    control);
  if (measurements.empty()) return false;
  if (arguments.errorPictures > 0) {
    log.note(fmt::format("{}: error of {}, and a reference of {} times their samples", job.scene().name,
                         counted(arguments.errorPictures, "picture"),
                         bench::kReferenceSamples * arguments.errorPictures));
  }
  const bool complete = arguments.errorPictures > 0
                            ? bench::measureError(renderer, job.scene(), measurements, arguments.errorPictures, control)
                            : bench::measureNoise(renderer, job.scene(), measurements, control);
  if (!complete) return false;
  for (Measurement& measurement : measurements) {
    report.rows.push_back({job.scene().name, job.scene().hash, std::move(measurement)});
  }
  return true;
}

}  // namespace

ExitCode runBenchScenes(const BenchArguments& arguments, const Log& log) {
  if (arguments.errorPictures == 1) throw UsageError("--error 1: an error needs at least 2 pictures, better 8");
  if (arguments.errorPictures > 0 && arguments.repeats < 2) {
    throw UsageError("--error: the time needs at least two runs; use --repeat 2 or more");
  }
  sweepOver(arguments);  // reports errors before any scene is loaded
  const std::unique_ptr<render::Renderer> renderer = makeRenderer(arguments, log);
  SweepReport report;
  report.repeats = arguments.repeats;
  for (const std::string& file : arguments.files) {
    BenchArguments one = arguments;
    one.files = {file};
    if (measureScene(one, *renderer, log, report)) continue;
    log.note("interrupted; nothing is written");
    return ExitCode::interrupted;
  }
  report.processBytes = peakProcessBytes();
  writeText(arguments.svg, bench::toSvg(report));
  return publish(report, arguments, log, "the images of some variants differ; their times are left out", arguments.svg);
}

}  // namespace candela::cli
