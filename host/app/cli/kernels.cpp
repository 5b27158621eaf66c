// `candela kernels`: reports what a driver makes of the kernels of scenes, and compares two reports.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/commands.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/render_job.h"
#include "host/app/cli/requirements.h"
#include "host/app/cli/text_output.h"
#include "host/app/cli/tuned.h"
#include "host/base/interrupt.h"
#include "host/drivers/kernels/kernel_comparison.h"
#include "host/drivers/kernels/kernel_reporter.h"
#include "host/measure/bench/report_file.h"
#include "host/measure/tune/work.h"

namespace candela::cli {
namespace {

// Drivers would otherwise take kernels that they have compiled before from caches of their own.
void disableDriverCaches() {
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
  ::setenv("__GL_SHADER_DISK_CACHE", "0", 0);
}

ExitCode publish(const auto& report, const KernelsArguments& arguments, ExitCode code) {
  if (wantsText(arguments, {arguments.json, arguments.markdown})) std::cout << toText(report) << std::flush;
  writeText(arguments.markdown, toMarkdown(report));
  writeJson(arguments.json, toJson(report));
  return code;
}

void refuseOptionsOfScenes(const KernelsArguments& arguments) {
  for (const std::string& option : arguments.given) {
    static constexpr std::array kOfComparison{"--threshold", "--json", "--markdown", "--quiet", "--verbose"};
    if (std::ranges::find(kOfComparison, option) != kOfComparison.end()) continue;
    throw UsageError(fmt::format("kernels compare {}: this option applies only to kernels SCENE", option));
  }
}

ExitCode compareFiles(const KernelsArguments& arguments) {
  if (arguments.files.size() != 3)
    throw UsageError("kernels compare: expected two reports, the old one and the new one");
  refuseOptionsOfScenes(arguments);
  const std::string &before = arguments.files[1], &after = arguments.files[2];
  const auto comparison = kernels::compareReports(bench::readReport(before), before, bench::readReport(after), after,
                                                  arguments.threshold);
  return publish(comparison, arguments, comparison.regressed() ? ExitCode::differ : ExitCode::done);
}

std::vector<RenderJob> jobsOf(const KernelsArguments& arguments, const Log& log) {
  std::vector<RenderJob> jobs;
  for (const std::string& file : arguments.files) {
    KernelsArguments one = arguments;
    one.files = {file};
    jobs.push_back(loadJob(one, log));
  }
  if (!jobs.empty()) return jobs;
  for (scene::Scene& scene : tune::builtInScenes())
    jobs.push_back(jobOf(arguments, std::make_shared<const scene::Scene>(std::move(scene)), log));
  return jobs;
}

std::vector<render::KernelKind> kernelsOf(const KernelsArguments& arguments, const render::RenderSettings& settings) {
  if (!arguments.all || settings.image.integrator != render::Integrator::path) return {settings.execution.kernel};
  return {render::KernelKind::megakernel, render::KernelKind::wavefront};
}

kernels::KernelReport report(const KernelsArguments& arguments, const Log& log) {
  const std::vector<RenderJob> jobs = jobsOf(arguments, log);
  kernels::KernelReporter reporter(arguments.device);
  const render::AutomaticChoices choices = automaticChoices(arguments, reporter.device(), log);
  kernels::KernelReport report{reporter.device(), {}};
  for (const RenderJob& job : jobs) {
    render::RenderSettings settings = job.settings;
    settings.execution.automatic = choices;
    for (const render::KernelKind kernel : kernelsOf(arguments, settings)) {
      settings.execution.kernel = kernel;
      std::ranges::move(reporter.rowsOf(job.scene(), settings), std::back_inserter(report.rows));
      if (watchInterrupts()) throw InterruptedError("interrupted; nothing was written");
    }
  }
  return report;
}

}  // namespace

ExitCode run(const KernelsArguments& arguments, const Log& log) {
  for (const std::string& target : {arguments.json, arguments.markdown}) requireWritableReport(target);
  if (!arguments.files.empty() && arguments.files.front() == "compare") return compareFiles(arguments);
  requireVulkanDevice(arguments, "the reference tracer has no kernels");
  if (arguments.all && arguments.given.contains("--kernel"))
    throw UsageError("--all-kernels and --kernel exclude each other");
  disableDriverCaches();
  watchInterrupts();
  return publish(report(arguments, log), arguments, ExitCode::done);
}

}  // namespace candela::cli
