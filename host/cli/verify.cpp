// `candela verify`: the verdict on a device.
#include "host/verify/verify.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/cli/bad_samples.h"
#include "host/cli/commands.h"
#include "host/cli/json_output.h"
#include "host/cli/output_check.h"
#include "host/cli/render_job.h"
#include "host/cli/report_page.h"
#include "host/cli/text_output.h"
#include "host/core/interrupt.h"
#include "host/render/make_renderer.h"

namespace candela::cli {

ExitCode runVerify(const Arguments& arguments, const Log& log) {
  if (arguments.device == "cpu") {
    throw UsageError("--device cpu: the reference would be verified by itself; name another tracer, see candela devices");
  }
  requireWritableReport(arguments.json);
  requireWritableReport(arguments.junit);
  if (!arguments.report.empty()) requireWritableFile(arguments.report);
  const RenderJob job = loadJob(arguments, log);
  const std::unique_ptr<Renderer> device = makeRenderer(arguments.device);
  const std::unique_ptr<Renderer> reference = makeReferenceRenderer();
  RenderControl control;
  control.stop = &watchInterrupts();
  verify::LightTestOptions options = arguments.verification;
  options.keepFilms = !arguments.report.empty();
  const verify::VerifyReport report = verify::verifyScene(job.scene, job.settings, *device, *reference, options, control);
  if (arguments.wantsText() && arguments.junit != "-") std::cout << toText(report) << std::flush;
  reportBadSamples(report.deviceBadSamples, report.referenceBadSamples, job, log);
  writeText(arguments.junit, toJunit(report, arguments.strict));
  nlohmann::ordered_json json = toJson(report);
  json["badSamples"] = badSamplesJson(report.deviceBadSamples, report.referenceBadSamples, job);
  writeJson(arguments.json, json);
  if (options.keepFilms && !report.interrupted) writeReport(arguments.report, verificationReport(arguments, job, report));
  const ExitCode code = report.agree() ? ExitCode::done : ExitCode::differ;
  return strictly(report.interrupted ? ExitCode::interrupted : code, report.badSamples(), arguments, log);
}

}  // namespace candela::cli
