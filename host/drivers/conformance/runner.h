// Runs cases in child processes, several at a time, and judges their results.
#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/drivers/conformance/case.h"
#include "host/drivers/conformance/expectations.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::conformance {

struct CaseResult {
  std::string name;
  Verdict verdict;
  std::string text;    ///< what differs, the missing feature, or how the child ended; empty if the case passed
  double seconds = 0;  ///< duration of the case
};

struct RunOptions {
  std::uint32_t jobs = 1;                     ///< maximum number of child processes at a time, >= 1
  std::chrono::milliseconds timeout{60'000};  ///< for each case
  std::optional<std::uint32_t> shuffle{};     ///< seed of the order of the cases; absent: the order of the table
  bool compilesOnly = false;                  ///< the pipelines of the cases are created, and nothing is run
  Expectations expectations{};
  const std::atomic<bool>* stop = nullptr;        ///< polled; if true, the children are killed and the run ends
  std::function<void(const CaseResult&)> note{};  ///< called with each result; may be empty
};

struct RunResult {
  std::vector<CaseResult> cases;  ///< sorted by name; those that ended
  bool interrupted = false;
  bool compilesOnly = false;  ///< RunOptions::compilesOnly

  /// Returns whether every case ended with the expected result.
  bool isExpected() const;
};

/// Runs `cases` on the device. Cases of one group share a child process as long as none of them crashes or hangs: the
/// cases after it run again, one by one. A case whose result is unexpected runs a second time after all others, while
/// no other case runs; if the second result is expected, the case is a flake. Call it while this process has one
/// thread. Throws InternalError if no child can be started.
RunResult runCases(const Cases& cases, const vulkan::DeviceInfo& device, const RunOptions& options);

}  // namespace candela::conformance
