// Runs long work without the global interpreter lock (GIL).
#pragma once
#include <pybind11/pybind11.h>

#include <atomic>
#include <cstdint>
#include <functional>

namespace candela::python {

/// The work's connection to its caller. Both members may be used from any thread, without the GIL.
struct Watch {
  const std::atomic<bool>& stop;  ///< true: the work is to end early, since its result is no longer wanted
  std::function<void(double fraction, std::uint64_t samples)> report;
};

/// Runs `work` on a separate thread, and returns when it has ended. Meanwhile the calling thread, which holds the GIL
/// and gives it away, handles signals and calls `progress` (a callable, or None) with the last report, at most 20 times
/// per second, and once with the last one when the work is done. An exception of either, such as KeyboardInterrupt,
/// stops the work and is thrown when it has ended. Otherwise throws the exceptions of `work`.
void runWatched(const std::function<void(const Watch&)>& work, const pybind11::object& progress = pybind11::none());

}  // namespace candela::python
