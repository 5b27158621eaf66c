// Keeps a GPU busy before its work is timed.
//
// The clock of a GPU falls while it has nothing to do: while the host reads a scene, builds its acceleration structure
// or hashes a film. Work that takes milliseconds would then be timed at any clock. Processors that run kernels in
// software are busy with the host's work, and are not warmed up.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "host/trace/render/session.h"

namespace candela::bench {

/// Maximum duration of a warm-up in seconds.
inline constexpr double kMaxWarmUpSeconds = 1;
/// Duration in seconds over which a rate of work is measured. A warm-up has at least two such windows.
inline constexpr double kWarmUpWindow = 0.05;
/// A device is warm when the rate of a window exceeds that of the window before it by at most this fraction.
inline constexpr double kWarmUpTolerance = 0.02;

/// The work before timed runs, which no figure includes.
struct WarmUpWork {
  double seconds = 0;        ///< of tracing
  std::uint32_t passes = 0;  ///< how often the work was done, the last time perhaps in part

  void add(const WarmUpWork& other) {
    seconds += other.seconds;
    passes += other.passes;
  }
};

/// Returns how figures were measured, e.g. "median of 3, runs interleaved, each after a warm-up of 0.21 s" with the
/// mean over all `runs`, or without its last part if there was no warm-up. `all` is the work before all runs together.
std::string repetitionText(std::uint32_t repeats, const WarmUpWork& all, std::size_t runs);

/// Decides from the rate of passes when a device has reached its speed.
class WarmUp {
 public:
  /// Adds a pass that did an amount of work, in any unit, in so many seconds.
  void add(double seconds, double amount);
  /// Returns whether the rate has stopped rising, or kMaxWarmUpSeconds have passed.
  bool isDone() const { return isStable_ || work_.seconds >= kMaxWarmUpSeconds; }
  const WarmUpWork& work() const { return work_; }

 private:
  WarmUpWork work_;
  double windowSeconds_ = 0;
  double windowAmount_ = 0;
  std::optional<double> rate_;  ///< of the last window
  bool isStable_ = false;
};

/// Renders all samples of a session on a GPU until it is warm, and resets the session. The last pass is stopped after
/// kMaxWarmUpSeconds. Other sessions do nothing. Returns nothing if `control` stopped it; progress is not reported.
/// Throws the exceptions of Session::advance.
std::optional<WarmUpWork> warmUp(render::Session& session, const render::ImageSettings& image,
                                 const render::RenderControl& control);

}  // namespace candela::bench
