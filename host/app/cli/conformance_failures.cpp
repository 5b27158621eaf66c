// Shrinks and captures failures.
#include "host/app/cli/conformance_failures.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "host/base/errors.h"
#include "host/base/interrupt.h"
#include "host/drivers/capture/folder.h"
#include "host/drivers/child_process.h"
#include "host/drivers/conformance/capture_case.h"

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

// Returns the description of the smallest difference; nothing after an interruption.
std::optional<std::string> shrunk(const Case& question, const vulkan::DeviceInfo& device,
                                  const conformance::ShrinkLimits& limits) {
  try {
    return question.shrink(device, limits);
  } catch (const InterruptedError&) {
    return std::nullopt;
  }
}

// A driver that crashes ends only a child process.
void captureFailure(const Case& question, const vulkan::DeviceInfo& device, const std::filesystem::path& folder,
                    const Log& log) {
  const std::filesystem::path target = folder / question.name;
  const auto work = [&] {
    capture::writeFolder(conformance::captureCase(question, device), target);
    return nlohmann::json(true);
  };
  const process::ChildResult result = process::runInChild(kCaptureLimit, work, &watchInterrupts());
  if (!result.failure.empty()) capture::removeRemains(target);
  if (result.interrupted) return;
  if (result.failure.empty()) {
    log.note(fmt::format("{}: captured in {}", question.name, target.string()));
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
    const std::optional<std::string> text = shrunk(question, device, limits);
    if (!text) return;
    log.note(fmt::format("{}: {}", result.name, *text));
    result.text += "\n" + *text;
  }
}

void captureFailures(const std::filesystem::path& folder, const conformance::RunResult& run, const Cases& cases,
                     const vulkan::DeviceInfo& device, const Log& log) {
  if (folder.empty()) return;
  bool isNew = false;
  std::error_code ignored;
  for (const CaseResult& result : run.cases) {
    if (result.verdict.status != conformance::Status::fail || watchInterrupts()) continue;
    isNew = std::filesystem::create_directory(folder, ignored) || isNew;
    captureFailure(caseNamed(cases, result.name), device, folder, log);
  }
  if (isNew) std::filesystem::remove(folder, ignored);  // fails if there is a capture
}

}  // namespace candela::cli
