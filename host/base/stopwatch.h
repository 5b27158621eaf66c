// Durations of phases, by a monotonic clock.
#pragma once
#include <chrono>

namespace candela {

class Stopwatch {
 public:
  /// Returns the seconds since construction or the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - last_;
    last_ = now;
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace candela
