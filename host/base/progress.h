// Reports the progress of a render: one line that is rewritten on a terminal, or occasional plain lines elsewhere.
#pragma once
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <mutex>
#include <string>

#include "host/base/log.h"

namespace candela {

enum class ProgressStyle { none, terminal, plain };

/// Returns `none` if quiet, otherwise a style that depends on whether stderr is a terminal.
ProgressStyle progressStyle(Verbosity verbosity);

/// Returns the seconds of a monotonic clock.
double monotonicSeconds();

class Progress {
 public:
  using Clock = std::function<double()>;

  /// Starts the clock. The destructor clears the line.
  Progress(std::ostream& sink, ProgressStyle style, Clock clock = monotonicSeconds);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Reports that `fraction`, in [0, 1], of the work is done. Thread-safe and cheap. A terminal gets at most ten
  /// updates per second. A plain log gets a line every 10 %, but not within 5 s of the last line, or else every minute.
  /// `head` begins the text.
  void update(double fraction, std::uint64_t samplesDone, const std::string& head = {});
  /// Removes the line on the terminal until the next update, so that a message can be printed.
  void clear();

 private:
  bool isDue(double now, double fraction) const;

  std::ostream& sink_;
  ProgressStyle style_;
  Clock clock_;
  double start_;
  double shownAt_;
  double shownFraction_ = 0;
  std::mutex mutex_;
};

/// E.g. "42 %, 12.3 Msamples/s, 8 s left".
std::string progressText(double fraction, std::uint64_t samplesDone, double elapsedSeconds);
/// E.g. "8 s", "2 min 5 s", "3 h 20 min".
std::string durationText(double seconds);

}  // namespace candela
