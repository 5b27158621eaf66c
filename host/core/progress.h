// Says how far a render is: one line that is rewritten on a terminal, few plain lines elsewhere.
#pragma once
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <mutex>
#include <string>

#include "host/core/log.h"

namespace candela {

enum class ProgressStyle { none, terminal, plain };

/// `none` when quiet; otherwise by whether stderr is a terminal.
ProgressStyle progressStyle(Verbosity verbosity);

/// Seconds of a clock that never goes back.
double monotonicSeconds();

class Progress {
 public:
  using Clock = std::function<double()>;

  /// Time counts from here. The destructor removes the terminal's line.
  Progress(std::ostream& sink, ProgressStyle style, Clock clock = monotonicSeconds);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// May be called often and from several threads. `fraction` is in [0, 1]. A terminal sees at most ten updates a
  /// second; a plain log a line after at least 5 s that brought 10 %, or else after a minute.
  void update(double fraction, std::uint64_t samplesDone);

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
