// One function on several threads, whose exceptions reach the caller.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>

namespace candela {

/// Calls work(i, stop) for the indices i below `count`, each on a thread of its own; work(0) runs on the calling
/// thread. If the system permits fewer threads, the last indices are left out, so that `work` must take its tasks from
/// a common queue. Returns when all calls have returned. After an exception, a stop is requested from the others, and
/// the first exception is rethrown.
void runOnThreads(std::uint32_t count, const std::function<void(std::uint32_t, const std::stop_token&)>& work);

/// Returns `asked`, or the number of cores if it is 0.
std::uint32_t threadCountFor(std::uint32_t asked);

/// Calls work(thread, i) for all indices i below `count`, on at most `threadCount` threads, which take the indices in
/// rising order. Exceptions as for runOnThreads().
void forEachOnThreads(std::uint32_t threadCount, std::size_t count,
                      const std::function<void(std::uint32_t thread, std::size_t i)>& work);

/// Divides the indices below `count` into blocks, and calls work(begin, end) for each as forEachOnThreads() does.
void forEachBlock(std::uint32_t threadCount, std::size_t count,
                  const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace candela
