// One function on several threads, whose exceptions reach the caller.
#pragma once
#include <cstdint>
#include <functional>
#include <stop_token>

namespace candela {

/// Calls work(i, stop) for the indices i below `count`, each on a thread of its own; work(0) runs on the calling
/// thread. If the system permits fewer threads, the last indices are left out, so that `work` must take its tasks from
/// a common queue. Returns when all calls have returned. After an exception, a stop is requested from the others, and
/// the first exception is rethrown.
void runOnThreads(std::uint32_t count, const std::function<void(std::uint32_t, const std::stop_token&)>& work);

}  // namespace candela
