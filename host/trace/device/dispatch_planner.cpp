// Spreads the first dispatches over a band, then sweeps.
#include "host/trace/device/dispatch_planner.h"

#include <array>

namespace candela::device {

DispatchPlanner::DispatchPlanner(const TileCursor& cursor, const GovernorOptions& options, std::uint32_t height)
    : cursor_(cursor), governor_(options), height_(height) {
  governor_.record(governor_.next(), 0, 0);  // the dispatch that compiles
}

// Moves to the centre of another eighth of the band, far from the last one (bit reversal); after the last probe, to the
// start of the first sweep.
void DispatchPlanner::probe() {
  constexpr std::array<std::uint64_t, 8> kEighths{0, 4, 2, 6, 1, 5, 3, 7};
  isProbing_ = governor_.isProbing();
  const std::uint64_t eighth = kEighths[probes_++ % kEighths.size()];
  cursor_.moveTo(isProbing_ ? static_cast<std::uint32_t>((2 * eighth + 1) * height_ / 16) : 0);
}

PlannedDispatch DispatchPlanner::next(const UnfinishedRows& unfinished) {
  if (isProbing_) probe();
  const Rect region = cursor_.next(unfinished.pixelsHolding(governor_.next().pixels, cursor_.row()));
  const std::uint64_t active = unfinished.activeIn(region);
  return {region, active, governor_.segmentsFor(active)};
}

void DispatchPlanner::record(const PlannedDispatch& dispatch, double seconds) {
  const std::uint64_t pixels = std::uint64_t{dispatch.region.width} * dispatch.region.height;
  governor_.record({pixels, dispatch.segments}, dispatch.activePixels, seconds);
  if (!isProbing_ && cursor_.isAtStart()) ++sweeps_;
}

}  // namespace candela::device
