// `candela conformance`: runs many small cases on a device, each in a child process.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/commands.h"
#include "host/app/cli/conformance_failures.h"
#include "host/app/cli/did_you_mean.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/requirements.h"
#include "host/app/cli/text_output.h"
#include "host/base/interrupt.h"
#include "host/base/run_on_threads.h"
#include "host/base/stopwatch.h"
#include "host/drivers/capture/folder.h"
#include "host/drivers/conformance/case_tables.h"
#include "host/drivers/conformance/results.h"
#include "host/drivers/doctor/devices.h"
#include "host/trace/vulkan/device_choice.h"

namespace candela::cli {
namespace {

using conformance::CaseResult;
using conformance::Cases;

[[noreturn]] void refuseNames(const std::string& pattern, const ConformanceArguments& arguments) {
  const bool needsVariants = !arguments.variants && pattern.starts_with("variants.");
  throw UsageError(fmt::format("--cases {}: no case has such a name{}; `candela conformance{} --list` prints all names",
                               pattern, needsVariants ? " without --variants" : "",
                               needsVariants || arguments.variants ? " --variants" : ""));
}

Cases chosenCases(const ConformanceArguments& arguments) {
  const Cases all = arguments.variants ? conformance::variantCases() : conformance::allCases(arguments.pictures);
  if (arguments.cases.empty()) return all;
  for (const std::string& pattern : arguments.cases) {
    if (conformance::casesNamed(all, {pattern}).empty()) refuseNames(pattern, arguments);
  }
  return conformance::casesNamed(all, arguments.cases);
}

void printNames(const Cases& cases) {
  for (const conformance::Case& one : cases) std::cout << one.name << '\n';
  std::cout << std::flush;
}

// A driver that crashes while it lists its devices ends only a child process.
vulkan::DeviceInfo deviceFor(const ConformanceArguments& arguments) {
  doctor::ListedDevices listed = doctor::listAllDevices();
  if (!listed.failure.empty()) {
    throw NoDeviceError(
        fmt::format("listing the Vulkan devices {}; `candela doctor` names the driver", listed.failure));
  }
  if (arguments.compileOnly) vulkan::allowCompilers(listed.devices);
  return vulkan::chooseDevice(listed.devices, arguments.device);
}

// A mistyped name in a baseline would be ignored silently. Cases of the other list are known, too.
void warnOfUnknownCases(const std::filesystem::path& file, const conformance::Baseline& baseline, const Log& log) {
  std::vector<std::string> names;
  for (const Cases& cases : {conformance::allCases(), conformance::variantCases()}) {
    for (const conformance::Case& one : cases) names.push_back(one.name);
  }
  for (const auto& [name, status] : baseline) {
    if (std::ranges::find(names, name) != names.end()) continue;
    log.warning(fmt::format("{}: there is no case {}{}", file.string(), name, didYouMean(name, names)));
  }
}

conformance::Expectations readExpectations(const ConformanceArguments& arguments, const Log& log) {
  conformance::Expectations expectations;
  for (const std::filesystem::path& file : arguments.baselines) {
    const conformance::Baseline baseline = conformance::readBaseline(file);
    warnOfUnknownCases(file, baseline, log);
    conformance::addBaseline(baseline, file.string(), expectations.baseline);
  }
  for (const std::filesystem::path& file : arguments.skips) expectations.skips.add(conformance::readPatterns(file));
  for (const std::filesystem::path& file : arguments.flakes) expectations.flakes.add(conformance::readPatterns(file));
  return expectations;
}

conformance::RunOptions optionsFrom(const ConformanceArguments& arguments, const Log& log) {
  conformance::RunOptions options;
  options.jobs = arguments.jobs.value_or(threadCountFor(0));
  options.timeout = std::chrono::milliseconds(static_cast<std::int64_t>(arguments.timeout * 1000));
  options.shuffle = arguments.shuffle;
  options.compilesOnly = arguments.compileOnly;
  options.expectations = readExpectations(arguments, log);
  return options;
}

// Results that are expected appear only with --verbose.
bool isWorthALine(const CaseResult& result, const Log& log) {
  return !result.verdict.isExpected() || result.verdict.status == conformance::Status::flake ||
         log.verbosity() == Verbosity::verbose;
}

void refuseOptionsOfRuns(const ConformanceArguments& arguments) {
  for (const char* const option : {"--capture", "--shrink-time", "--seed", "--alpha"}) {
    if (!arguments.given.contains(option)) continue;
    throw UsageError(fmt::format("{}: this option applies only to cases that run, without --compile-only", option));
  }
}

// Failures to compile do not shrink, because the search runs the case.
double shrinkSecondsOf(const ConformanceArguments& arguments) {
  return arguments.compileOnly ? 0 : arguments.shrinkSeconds;
}

void requireWritableOutputs(const ConformanceArguments& arguments) {
  if (!arguments.captures.empty()) capture::requireNewFolder(arguments.captures);
  for (const std::string& target : {arguments.csv, arguments.json, arguments.junit}) {
    requireWritableReport(target);
  }
}

}  // namespace

ExitCode run(const ConformanceArguments& arguments, const Log& log) {
  requireVulkanDevice(arguments, "the cases test a Vulkan driver, which the reference tracer does not use");
  if (arguments.compileOnly) refuseOptionsOfRuns(arguments);
  const Cases cases = chosenCases(arguments);
  if (arguments.list) {
    printNames(cases);
    return ExitCode::done;
  }
  requireWritableOutputs(arguments);
  conformance::RunOptions options = optionsFrom(arguments, log);
  const bool asText = wantsText(arguments, {arguments.json, arguments.junit, arguments.csv});
  options.note = [&](const CaseResult& result) {
    if (asText && isWorthALine(result, log)) std::cout << lineOf(result) << std::flush;
  };
  const vulkan::DeviceInfo device = deviceFor(arguments);
  log.note(fmt::format("{} cases on {} ({}), {} at a time", cases.size(), device.name, device.driver, options.jobs));
  options.stop = &watchInterrupts();
  Stopwatch watch;
  conformance::RunResult run = conformance::runCases(cases, device, options);
  shrinkFailures({options.timeout, shrinkSecondsOf(arguments), options.stop}, run, cases, device, log);
  const double seconds = watch.lap();
  if (asText) std::cout << fmt::format("{} ({:.1f} s)\n", countsOf(run), seconds) << std::flush;
  writeText(arguments.csv, toCsv(run));
  writeText(arguments.junit, toJunit(run, device, seconds));
  writeJson(arguments.json, toJson(run, device, seconds));
  captureFailures(arguments.captures, run, cases, device, log);
  if (*options.stop) {
    log.problem(interruptionOf(run, cases.size()));
    return ExitCode::interrupted;
  }
  return run.isExpected() ? ExitCode::done : ExitCode::differ;
}

}  // namespace candela::cli
