// Detects devices whose dispatches succeed without doing their work.
#pragma once
#include <cstdint>
#include <optional>

namespace candela::device {

/// A driver that loses invocations or atomic operations reports no error, but the pixels that it has left out never
/// finish. Each dispatch advances every unfinished path by a segment at least, and thus changes its state. If no sample
/// has finished for many sweeps, the states of all paths are compared with those some sweeps later.
class StallWatch {
 public:
  static constexpr std::uint64_t kSweeps = 16;  ///< between two comparisons

  /// Records the state after a dispatch: how many samples it finished, and how many sweeps there have been since the
  /// render began. Returns whether the states are to be compared.
  bool mustCompare(std::uint64_t samplesFinished, std::uint64_t sweeps);
  /// Returns whether no state has changed since the last comparison. `hash` is that of the states of all paths.
  bool isStalled(std::uint64_t hash);

 private:
  std::uint64_t sweepsBefore_ = 0;     ///< when a sample finished or the states were compared
  std::optional<std::uint64_t> hash_;  ///< of the last comparison since a sample finished
};

}  // namespace candela::device
