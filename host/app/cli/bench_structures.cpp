// `candela bench table1` and `bench accel SCENE...`: times acceleration structures on the same scenes.
#include <fmt/format.h>

#include <array>
#include <iostream>

#include "embedded/balls.h"
#include "embedded/mirror.h"
#include "host/app/cli/bench_output.h"
#include "host/app/cli/commands.h"
#include "host/app/cli/render_job.h"
#include "host/base/counted.h"
#include "host/base/progress.h"
#include "host/formats/nff/nff_loader.h"
#include "host/measure/bench/structure_report.h"

namespace candela::cli {
namespace {

using bench::Measurement;
using bench::RenderRow;
using bench::StructureReport;
using bench::Variant;

// A built-in scene, and its published seconds at 512 x 512 with 15 x 15 rays per pixel (docs/comparison.md).
struct PublishedScene {
  const char* name;
  const std::string_view& text;
  bool oneSided;
  double gridSeconds;
  double bvhSeconds;
};
const std::array kTable1{PublishedScene{"mirror", embedded::mirror, true, 361.0, 327.78},
                         PublishedScene{"balls", embedded::balls, false, 526.6, 512.43}};
constexpr std::uint32_t kTable1Samples = 15 * 15;

// Returns the rows of one scene, or none if the run was interrupted.
std::vector<RenderRow> measureScene(const RenderJob& job, std::uint32_t repeats, render::Renderer& renderer,
                                    const Log& log) {
  const scene::Scene& scene = job.scene();
  const render::RenderSettings& settings = job.settings;
  const std::vector<Variant> variants = bench::structureVariants(settings);
  log.note(fmt::format("{}: {}x{} pixels, {} per pixel, {} structures, runs of each: {}", scene.name,
                       settings.image.size.width, settings.image.size.height,
                       counted(settings.image.sampleCount, "sample"), variants.size(), repeats));
  Progress progress(std::cerr, progressStyle(log.verbosity()));
  std::vector<RenderRow> rows;
  for (Measurement& measurement : bench::measureInterleaved(renderer, scene, variants, repeats, makeControl(progress),
                                                            bench::Preparation::everyRun)) {
    rows.push_back({scene.name, scene.hash, std::move(measurement)});
  }
  return rows;
}

// Returns whether the published seconds are for this work.
bool isPublishedWork(const render::RenderSettings& settings) {
  return settings.image.integrator == render::Integrator::path && settings.image.sampleCount == kTable1Samples &&
         settings.image.size.width == 512 && settings.image.size.height == 512;
}

bool append(std::vector<RenderRow> rows, StructureReport& report) {
  for (RenderRow& row : rows) report.rows.push_back(std::move(row));
  return !rows.empty();
}

bool measureTable1(const BenchArguments& arguments, const Log& log, StructureReport& report) {
  const std::unique_ptr<render::Renderer> renderer = makeRenderer(arguments, log);
  for (const PublishedScene& published : kTable1) {
    auto scene = std::make_shared<const scene::Scene>(
        scene::parseScene(std::string(published.text), published.name, ".").scene);
    BenchArguments resolved = arguments;
    if (!resolved.request.sampleCount) resolved.request.sampleCount = kTable1Samples;
    if (!resolved.given.contains("--sampler")) resolved.request.image.sampler = render::SamplerKind::stratified;
    resolved.request.image.oneSided |= published.oneSided;
    const RenderJob job = jobOf(resolved, std::move(scene), log);
    std::vector<RenderRow> rows = measureScene(job, arguments.repeats, *renderer, log);
    for (RenderRow& row : rows) {
      const render::RenderSettings& variant = row.measurement.variant.settings;
      if (!isPublishedWork(variant)) break;
      if (variant.structure.accel == render::AccelKind::grid) row.publishedSeconds = published.gridSeconds;
      if (variant.structure.accel == render::AccelKind::bvh &&
          variant.structure.bvhSplit == render::BvhSplit::midpoint) {
        row.publishedSeconds = published.bvhSeconds;
      }
    }
    if (!append(std::move(rows), report)) return false;
  }
  return true;
}

bool measureFiles(const BenchArguments& arguments, const Log& log, StructureReport& report) {
  const std::unique_ptr<render::Renderer> renderer = makeRenderer(arguments, log);
  for (std::size_t i = 1; i < arguments.files.size(); ++i) {
    BenchArguments one = arguments;
    one.files = {arguments.files[i]};
    const RenderJob job = loadJob(one, log);
    if (!append(measureScene(job, arguments.repeats, *renderer, log), report)) return false;
  }
  return true;
}

}  // namespace

ExitCode runBenchStructures(const BenchArguments& arguments, const Log& log) {
  StructureReport report;
  report.repeats = arguments.repeats;
  const bool table1 = arguments.files.front() == "table1";
  const bool complete = table1 ? measureTable1(arguments, log, report) : measureFiles(arguments, log, report);
  if (!complete) {
    log.note("interrupted; nothing is written");
    return ExitCode::interrupted;
  }
  return publish(report, arguments, log, "the images of some structures differ; their times are left out",
                 arguments.svg);
}

}  // namespace candela::cli
