// `candela explain`: compares one sample on both tracers, vertex by vertex.
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/commands.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/render_job.h"
#include "host/app/cli/requirements.h"
#include "host/app/cli/text_output.h"
#include "host/judge/explain/explanation.h"
#include "host/judge/verify/agreement.h"
#include "host/trace/reference/reference_renderer.h"

namespace candela::cli {
namespace {

using explain::Explanation;

void publish(const Explanation& explanation, const ExplainArguments& arguments) {
  render::requireComplete(explanation.statistics);
  if (wantsText(arguments, {arguments.json})) std::cout << toText(explanation) << std::flush;
  writeJson(arguments.json, toJson(explanation));
}

// Renders both images at one sample per pixel to find the pixel.
ExitCode explainWorstPixel(const RenderJob& job, const ExplainArguments& arguments, const Log& log,
                           render::Renderer& device, render::Renderer& reference) {
  verify::PathRenders renders;  // `compare` reports bad samples
  const std::optional<verify::PixelAgreement> pixels = [&] {
    Progress progress(std::cerr, progressStyle(log.verbosity()));
    return verify::comparePaths(job.scene(), job.settings, device, reference, verify::LightTestOptions().alpha,
                                makeControl(progress), renders);
  }();
  if (!pixels) {
    log.note("interrupted before a sample was explained");
    return ExitCode::interrupted;
  }
  render::requireComplete(renders.deviceStatistics);
  if (const std::optional<Explanation> worst = explain::explainWorst(job.scene(), job.settings, *pixels, device,
                                                                     reference)) {
    publish(*worst, arguments);
    return ExitCode::done;
  }
  if (wantsText(arguments, {arguments.json})) std::cout << explain::nothingToExplain(*pixels) << std::endl;
  writeJson(arguments.json, explain::nothingJson(job.scene(), *pixels));
  return ExitCode::done;
}

}  // namespace

ExitCode run(const ExplainArguments& arguments, const Log& log) {
  requireExplainable(arguments);
  requireWritableReport(arguments.json);
  const RenderJob job = loadJob(arguments, log);
  const std::optional<render::PixelSample> sample = arguments.pixel
                                                        ? std::optional(sampleAskedFor(arguments, job.settings.image))
                                                        : std::nullopt;
  const std::unique_ptr<render::Renderer> device = makeRenderer(arguments, log);
  const std::unique_ptr<render::Renderer> reference = reference::makeReferenceRenderer();
  if (!sample) return explainWorstPixel(job, arguments, log, *device, *reference);
  publish(explain::explainSample(job.scene(), job.settings, *sample, *device, *reference), arguments);
  return ExitCode::done;
}

}  // namespace candela::cli
