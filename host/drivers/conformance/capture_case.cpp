// Records the work of a case.
#include "host/drivers/conformance/capture_case.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/drivers/capture/lanes.h"
#include "host/drivers/capture/replay.h"
#include "host/drivers/conformance/shader_run.h"
#include "host/drivers/conformance/workbench.h"

namespace candela::conformance {
namespace {

void requireCapturable(const Case& question, const Finding& finding, const vulkan::DeviceInfo& device) {
  if (finding.outcome == Outcome::skip) refuseMissing(device, finding.text);
  if (finding.expected.empty()) {
    throw UsageError(fmt::format("{}: this case states no values of a buffer, and cannot be captured", question.name));
  }
}

// The text of the case describes the difference better than words of buffers do, if all of its values are kept.
capture::Capture captureOf(const vulkan::Recording& recording, const Finding& finding,
                           const vulkan::DeviceInfo& device) {
  capture::Capture capture = capture::cutDown(recording);
  capture.expected = finding.expected;
  check(capture, device);
  if (finding.isPerInvocation) takeFewestInvocations(capture, device, kRunGroup);
  if (capture.differing > 0 && capture.wholeCount == 0) capture.found = finding.text;
  return capture;
}

}  // namespace

void refuseMissing(const vulkan::DeviceInfo& device, const std::string& feature) {
  throw UsageError(fmt::format("the case cannot be captured on {}, which lacks {}", device.name, feature));
}

capture::Capture captureCase(const Case& question, const vulkan::DeviceInfo& device,
                             const vulkan::PrepareShader& prepareShader) {
  capture::Capture capture;
  if (question.capture) {
    capture = question.capture(device);
  } else {
    const auto recording = std::make_shared<vulkan::Recording>();
    Workbench workbench(device, {.recording = recording, .prepareShader = prepareShader});
    const Finding finding = question.run(workbench);
    requireCapturable(question, finding, device);
    capture = captureOf(*recording, finding, device);
    capture.expectedBy = "the host";
    capture.capturedOn = fmt::format("{} ({})", device.name, device.driver);
    capture.deviceName = device.name;
  }
  capture.title = question.name;
  return capture;
}

}  // namespace candela::conformance
