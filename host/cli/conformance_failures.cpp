// Shrinks and captures failures.
#include "host/cli/conformance_failures.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/capture/folder.h"
#include "host/conformance/capture_case.h"
#include "host/core/interrupt.h"
#include "host/process/child_process.h"

namespace candela::cli {
namespace {

using conformance::Case;
using conformance::CaseResult;
using conformance::Cases;

/// Number of failures that are shrunk: a fault often shows in many variants.
constexpr std::size_t kMaxShrunk = 5;
constexpr std::chrono::minutes kCaptureLimit{5};

const Case& caseNamed(const Cases& cases, const std::string& name) {
  return *std::ranges::find(cases, name, &Case::name);
}

// A driver that crashes ends only a child process.
void captureFailure(const Case& question, const vulkan::DeviceInfo& device, const std::filesystem::path& folder,
                    const Log& log) {
  const process::ChildResult result = process::runInChild(kCaptureLimit, [&] {
    capture::writeFolder(conformance::captureCase(question, device), folder / question.name);
    return nlohmann::json(true);
  });
  if (result.failure.empty()) {
    log.note(fmt::format("{}: captured in {}", question.name, (folder / question.name).string()));
  } else {
    log.warning(fmt::format("{}: the process that captures it {}", question.name, result.failure));
  }
}

}  // namespace

void shrinkFailures(const conformance::ShrinkLimits& limits, conformance::RunResult& run, const Cases& cases,
                    const vulkan::DeviceInfo& device, const Log& log) {
  std::size_t left = limits.seconds > 0 ? kMaxShrunk : 0;
  for (CaseResult& result : run.cases) {
    const Case& question = caseNamed(cases, result.name);
    if (result.verdict.isExpected() || !question.shrink || left == 0 || watchInterrupts()) continue;
    --left;
    const std::string text = question.shrink(device, limits);
    log.note(fmt::format("{}: {}", result.name, text));
    result.text += "\n" + text;
  }
}

void captureFailures(const Arguments& arguments, const conformance::RunResult& run, const Cases& cases,
                     const vulkan::DeviceInfo& device, const Log& log) {
  const std::filesystem::path& folder = arguments.conformance.captures;
  if (folder.empty()) return;
  for (const CaseResult& result : run.cases) {
    if (result.verdict.status != conformance::Status::fail || watchInterrupts()) continue;
    std::error_code ignored;
    std::filesystem::create_directory(folder, ignored);
    captureFailure(caseNamed(cases, result.name), device, folder, log);
  }
}

}  // namespace candela::cli
