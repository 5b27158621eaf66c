// Decides whether a render whose device fails tries again, continues without the device, or ends.
#pragma once
#include <cstdint>
#include <string>

#include "host/cli/render_job.h"
#include "host/core/errors.h"

namespace candela::cli {

/// Counts the failures of one render.
class DeviceFailures {
 public:
  /// Both must outlive the object.
  DeviceFailures(const RenderJob& job, const Log& log)
      : job_(job), log_(log), dispatchSeconds_(job.settings.execution.dispatchSeconds) {}

  /// Returns whether the render may go on: the device was lost, or memory ran out; after a first failure, also if the
  /// device is not found any more, and with --fallback cpu if it was never found.
  bool isOne(const Error& error) const;
  /// Counts a failure. Returns whether the device is to be opened again, after a pause that grows with each failure,
  /// and says so; at most three times in all. Devices that hang cannot be opened again while they do, and one that was
  /// never found is not searched for again.
  bool mayTryAgain(const Error& error);
  int count() const { return count_; }

  /// Maximum size of a band's largest buffer: a quarter of the last one each time memory runs out.
  std::uint64_t maxBandBytes() const { return maxBandBytes_; }
  /// Target duration of a dispatch in seconds: a quarter of the last one each time the device is lost, because it may
  /// have been lost to a limit on the duration of work.
  double dispatchSeconds() const { return dispatchSeconds_; }

  /// The exit code of a render that ends by `error`: ExitCode::deviceLost or outOfMemory.
  static ExitCode codeOf(const Error& error);
  /// Returns the cause and the remedy. `film` is the file that contains the samples so far; empty if there is none.
  std::string explain(const Error& error, const std::string& film) const;

 private:
  void limitBands();

  const RenderJob& job_;
  const Log& log_;
  int count_ = 0;
  std::uint64_t maxBandBytes_ = ~std::uint64_t{0};
  double dispatchSeconds_;
};

}  // namespace candela::cli
