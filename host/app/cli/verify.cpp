// `candela verify`: prints the verdict on a device.
#include "host/judge/verify/verify.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/bad_samples.h"
#include "host/app/cli/commands.h"
#include "host/app/cli/conclusion_code.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/render_job.h"
#include "host/app/cli/report_page.h"
#include "host/app/cli/requirements.h"
#include "host/app/cli/text_output.h"
#include "host/base/interrupt.h"
#include "host/judge/explain/explanation.h"
#include "host/trace/reference/reference_renderer.h"

namespace candela::cli {
namespace {

// Adds the explanation to the report and prints it. If the paths of all pixels are equal, there is nothing to explain,
// whatever the verdict.
void explainWorst(const verify::VerifyReport& report, const RenderJob& job, render::Renderer& device,
                  render::Renderer& reference, bool asText, nlohmann::ordered_json& json) {
  const std::optional<explain::Explanation> worst = explain::explainWorst(job.scene(), job.settings, report.paths,
                                                                          device, reference);
  if (worst) render::requireComplete(worst->statistics);
  json["explanation"] = worst ? toJson(*worst) : nlohmann::ordered_json();
  if (asText)
    std::cout << "\n" << (worst ? toText(*worst) : explain::nothingToExplain(report.paths) + "\n") << std::flush;
}

}  // namespace

ExitCode run(const VerifyArguments& arguments, const Log& log) {
  requireVerifiable(arguments);
  if (arguments.explain) explain::requirePaths(arguments.request.image.integrator);
  requireWritableReport(arguments.json);
  requireWritableReport(arguments.junit);
  if (!arguments.report.empty()) requireWritableFile(arguments.report);
  const RenderJob job = loadJob(arguments, log);
  const std::unique_ptr<render::Renderer> device = makeRenderer(arguments, log);
  const std::unique_ptr<render::Renderer> reference = reference::makeReferenceRenderer();
  render::RenderControl control;
  control.stop = &watchInterrupts();
  verify::LightTestOptions options = arguments.verification;
  options.keepFilms = !arguments.report.empty();
  const verify::VerifyReport report = verify::verifyScene(job.scene(), job.settings, *device, *reference, options,
                                                          control);
  const bool asText = wantsText(arguments, {arguments.json, arguments.junit});
  if (asText) std::cout << toText(report) << std::flush;
  reportBadSamples(report.badSamples, job, log);
  nlohmann::ordered_json json = toJson(report);
  json["badSamples"] = badSamplesJson(report.badSamples, job);
  if (arguments.explain && !report.interrupted) explainWorst(report, job, *device, *reference, asText, json);
  writeText(arguments.junit, toJunit(report, {arguments.strict, arguments.allowUndecided}));
  writeJson(arguments.json, json);
  if (options.keepFilms && !report.interrupted)
    writeReport(arguments.report, verificationReport(arguments, job, report));
  const ExitCode code = report.interrupted ? ExitCode::interrupted : exitCodeOf(report.conclusion(), arguments);
  return strictly(code, report.badSamples.samples(), arguments, log);
}

}  // namespace candela::cli
