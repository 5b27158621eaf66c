// The time after which a device that has not finished its work counts as hung.
#pragma once
#include <cstdint>
#include <optional>

namespace candela::vulkan {

/// States whether a driver may compile a pipeline during a run.
enum class FirstRun {
  none,       ///< all pipelines of the run have run before
  ofPipeline  ///< some drivers compile a pipeline now
};

/// Unless the timeout is fixed, a run may take 50 times as long as the longest one so far, and at least 10 s; the first
/// run of a pipeline at least two minutes.
class HangLimit {
 public:
  /// `timeout` in seconds as in DeviceOptions::hangTimeout.
  explicit HangLimit(std::optional<double> timeout = 0, bool isSoftware = false);

  /// Returns the limit of the next run in seconds; infinite if there is none.
  double seconds(FirstRun first) const;
  /// Returns the same limit in the unit of vkWaitForFences.
  std::uint64_t nanoseconds(FirstRun first) const;
  /// Records the duration of a run that ended. Those that may have compiled do not count.
  void record(FirstRun first, double seconds);

 private:
  std::optional<double> fixed_;  ///< absent: automatic
  double longest_ = 0;
};

}  // namespace candela::vulkan
