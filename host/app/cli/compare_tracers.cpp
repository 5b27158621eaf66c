// `candela compare SCENE`: compares the images of the device and of the reference.
#include <iostream>

#include "host/app/cli/bad_samples.h"
#include "host/app/cli/comparison.h"
#include "host/app/cli/conclusion_code.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/render_job.h"
#include "host/app/cli/report_page.h"
#include "host/app/cli/requirements.h"
#include "host/app/cli/text_output.h"
#include "host/judge/verify/agreement.h"
#include "host/trace/reference/reference_renderer.h"

namespace candela::cli {

ExitCode compareTracersOnScene(const CompareArguments& arguments, const Log& log) {
  requireComparable(arguments);
  requireWritableReport(arguments.json);
  if (!arguments.report.empty()) requireWritableFile(arguments.report);
  const RenderJob job = loadJob(arguments, log);
  const std::unique_ptr<render::Renderer> device = makeRenderer(arguments, log);
  const std::unique_ptr<render::Renderer> reference = reference::makeReferenceRenderer();
  const verify::AgreementReport report = [&] {
    Progress progress(std::cerr, progressStyle(log.verbosity()));
    return verify::compareTracers(job.scene(), job.settings, *device, *reference, arguments.verification,
                                  makeControl(progress));
  }();
  render::requireComplete(report.deviceStatistics);
  if (wantsText(arguments, {arguments.json})) std::cout << report.toText() << std::flush;
  reportBadSamples(report.badSamples, job, log);
  nlohmann::ordered_json json = report.toJson();
  json["badSamples"] = badSamplesJson(report.badSamples, job);
  writeJson(arguments.json, json);
  if (!arguments.report.empty() && !report.interrupted) {
    writeReport(arguments.report, agreementReport(arguments, job, report));
  }
  const ExitCode code = report.interrupted ? ExitCode::interrupted : exitCodeOf(report.conclusion(), arguments);
  return strictly(code, report.badSamples.samples(), arguments, log);
}

}  // namespace candela::cli
