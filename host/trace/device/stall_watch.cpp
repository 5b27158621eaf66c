// Counts sweeps without finished samples.
#include "host/trace/device/stall_watch.h"

#include <utility>

namespace candela::device {

bool StallWatch::mustCompare(std::uint64_t samplesFinished, std::uint64_t sweeps) {
  if (samplesFinished > 0) hash_.reset();
  const bool isDue = samplesFinished == 0 && sweeps >= sweepsBefore_ + kSweeps;
  if (samplesFinished > 0 || isDue) sweepsBefore_ = sweeps;
  return isDue;
}

bool StallWatch::isStalled(std::uint64_t hash) { return std::exchange(hash_, hash) == hash; }

}  // namespace candela::device
