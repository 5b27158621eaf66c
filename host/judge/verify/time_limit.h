// Keeps a test of several looks within a time limit.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>

namespace candela::verify {

class TimeLimit {
 public:
  /// Without a value there is no limit.
  explicit TimeLimit(std::optional<double> seconds) : secondsLeft_(seconds) {}

  /// Takes the `seconds` of work that is not repeated, such as a preparation, from the time.
  void spend(double seconds) {
    if (secondsLeft_) *secondsLeft_ = std::max(0.0, *secondsLeft_ - seconds);
  }

  /// Call this after each look, which took `seconds`, with the number of samples so far and the number `wanted` at the
  /// next look. Returns `wanted`, or as many samples as there is time for if they take as long as those of the last
  /// look. Samples are added in multiples of `step`. A result of `samples` means that there is no time for another
  /// look.
  std::uint64_t affordable(double seconds, std::uint64_t samples, std::uint64_t wanted, std::uint64_t step = 1) {
    const double secondsPerStep = seconds / static_cast<double>((samples - samplesBefore_) / step);
    samplesBefore_ = samples;
    if (!secondsLeft_) return wanted;
    spend(seconds);
    if (*secondsLeft_ == 0) return samples;
    const std::uint64_t steps = (wanted - samples) / step;
    if (*secondsLeft_ >= secondsPerStep * static_cast<double>(steps)) return wanted;
    return samples + static_cast<std::uint64_t>(*secondsLeft_ / secondsPerStep) * step;
  }

 private:
  std::optional<double> secondsLeft_;
  std::uint64_t samplesBefore_ = 0;
};

}  // namespace candela::verify
