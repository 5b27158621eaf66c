// A case of the conformance run: a test of a device, with its finding.
#pragma once
#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "host/drivers/capture/capture.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::conformance {

class Workbench;

/// The finding of a case itself. The runner notices crashes and hangs.
enum class Outcome { pass, fail, skip };

struct Finding {
  Outcome outcome = Outcome::pass;
  std::string text;  ///< of a failure: what differs; of a skipped case: the missing feature
  /// The values that the buffers of the last dispatch must contain; empty for a picture.
  capture::ExpectedValues expected{};
  /// The case is a ShaderRun whose invocations do not read each other's inputs: some of them can run it alone.
  bool isPerInvocation = false;
};

Finding passed();
Finding failed(std::string text);
Finding skipped(std::string missingFeature);
/// Returns the finding with Finding::isPerInvocation.
Finding perInvocation(Finding finding);

/// Limits of a search for the smallest difference.
struct ShrinkLimits {
  std::chrono::milliseconds trial{60'000};  ///< of each run of the case
  double seconds = 60;                      ///< for the whole search
  const std::atomic<bool>* stop = nullptr;  ///< polled; if true, the search throws InterruptedError
};

struct Case {
  std::string name;   ///< parts of letters, digits and underscores, separated by dots
  std::string group;  ///< cases of one group may run in one child process, because they share kernels or images
  std::function<Finding(Workbench&)> run;
  /// Creates the pipelines of the case and runs nothing, on a workbench that only compiles; empty: the case has none.
  std::function<Finding(Workbench&)> compile{};
  /// Captures the case in a special way; empty: captureCase() records the work of run().
  std::function<capture::Capture(const vulkan::DeviceInfo&)> capture{};
  /// Describes the smallest difference after a failure; empty: the case does not shrink. Call it while the process has
  /// one thread.
  std::function<std::string(const vulkan::DeviceInfo&, const ShrinkLimits&)> shrink{};
};

using Cases = std::vector<Case>;

}  // namespace candela::conformance
