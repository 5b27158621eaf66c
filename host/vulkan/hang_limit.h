// The time after which a device that has not finished its work counts as hung.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>

#include "host/vulkan/device.h"

namespace candela::vulkan {

class HangLimit {
 public:
  /// `timeout` in seconds as in DeviceOptions::hangTimeout.
  explicit HangLimit(std::optional<double> timeout = 0, bool isSoftware = false);

  /// The limit of the next run in seconds; infinite if there is none.
  double seconds(Patience patience) const;
  /// The same for vkWaitForFences.
  std::uint64_t nanoseconds(Patience patience) const;
  /// Records the duration of a run that ended.
  void record(double seconds) { longest_ = std::max(longest_, seconds); }

 private:
  std::optional<double> fixed_;  ///< absent: automatic
  double longest_ = 0;
};

}  // namespace candela::vulkan
