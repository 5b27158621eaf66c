// Chooses the limit by the longest run so far.
#include "host/trace/vulkan/hang_limit.h"

#include <algorithm>
#include <limits>

namespace candela::vulkan {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kTimesLongest = 50;
constexpr double kMinSeconds = 10;
constexpr double kMinSecondsToCompile = 120;
constexpr double kMaxSeconds = 1e9;  // beyond that, nanoseconds do not fit into 64 bits

}  // namespace

HangLimit::HangLimit(std::optional<double> timeout, bool isSoftware) : fixed_(timeout) {
  if (!fixed_ && isSoftware) fixed_ = 0;
}

double HangLimit::seconds(FirstRun first) const {
  if (fixed_) return *fixed_ > 0 ? *fixed_ : kInfinite;
  const double minimum = first == FirstRun::ofPipeline ? kMinSecondsToCompile : kMinSeconds;
  return std::max(minimum, kTimesLongest * longest_);
}

std::uint64_t HangLimit::nanoseconds(FirstRun first) const {
  const double limit = seconds(first);
  if (limit > kMaxSeconds) return std::numeric_limits<std::uint64_t>::max();
  return static_cast<std::uint64_t>(limit * 1e9);
}

void HangLimit::record(FirstRun first, double seconds) {
  if (first == FirstRun::none) longest_ = std::max(longest_, seconds);
}

}  // namespace candela::vulkan
