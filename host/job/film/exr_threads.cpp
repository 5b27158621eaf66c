// Sets the size of OpenEXR's pool of threads.
#include "host/job/film/exr_threads.h"

#include <OpenEXR/ImfThreading.h>

#include <algorithm>
#include <thread>

namespace candela::film {

std::uint32_t exrThreads() {
  static const std::uint32_t threads = [] {
    const std::uint32_t count = std::clamp(std::thread::hardware_concurrency(), 1u, 16u);
    Imf::setGlobalThreadCount(static_cast<int>(count));
    return count;
  }();
  return threads;
}

}  // namespace candela::film
