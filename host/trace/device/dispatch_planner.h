// Chooses the region and the number of segments of each dispatch of a band.
#pragma once
#include <cstdint>

#include "host/trace/device/governor.h"
#include "host/trace/device/tile_cursor.h"
#include "host/trace/device/unfinished_rows.h"

namespace candela::device {

/// The next dispatch: its region, the estimated number of pixels in it that have work left, and the maximum number of
/// segments of each.
struct PlannedDispatch {
  Rect region;
  std::uint64_t activePixels = 0;
  std::uint32_t segments = 0;
};

/// Sweeps over a band by what its governor permits. At first, dispatches are spread over the height of the band, so
/// that the governor knows the cost of its regions before one of them gets much work; then the sweeps begin.
class DispatchPlanner {
 public:
  /// `cursor` and `options` are those of the band, of `height` rows. The kernel must be compiled.
  DispatchPlanner(const TileCursor& cursor, const GovernorOptions& options, std::uint32_t height);

  PlannedDispatch next(const UnfinishedRows& unfinished);
  /// Records the duration of the dispatch that next() returned last.
  void record(const PlannedDispatch& dispatch, double seconds);
  /// Number of times that the sweeps have covered the whole band.
  std::uint64_t sweeps() const { return sweeps_; }

 private:
  void probe();

  TileCursor cursor_;
  Governor governor_;
  std::uint32_t height_;
  std::uint32_t probes_ = 0;
  bool isProbing_ = true;
  std::uint64_t sweeps_ = 0;
};

}  // namespace candela::device
