// Chooses the limit by the longest run so far.
#include "host/vulkan/hang_limit.h"

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

double HangLimit::seconds(Patience patience) const {
  if (fixed_) return *fixed_ > 0 ? *fixed_ : kInfinite;
  const double minimum = patience == Patience::compiles ? kMinSecondsToCompile : kMinSeconds;
  return std::max(minimum, kTimesLongest * longest_);
}

std::uint64_t HangLimit::nanoseconds(Patience patience) const {
  const double limit = seconds(patience);
  if (limit > kMaxSeconds) return std::numeric_limits<std::uint64_t>::max();
  return static_cast<std::uint64_t>(limit * 1e9);
}

}  // namespace candela::vulkan
