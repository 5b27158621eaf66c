// Estimates for each row of a band the number of pixels that lack samples.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/trace/device/tile_cursor.h"

namespace candela::device {

/// The device reports how many pixels a dispatch finished, but not which. They are assumed to be spread evenly over the
/// dispatch's rows.
class UnfinishedRows {
 public:
  /// `unfinished` has the number of such pixels of each row.
  UnfinishedRows(std::uint32_t width, std::span<const std::uint32_t> unfinished)
      : width_(width), rows_(unfinished.begin(), unfinished.end()) {}

  /// Number of pixels of the region that have work left, at least 1.
  std::uint64_t activeIn(const Rect& region) const;
  /// Number of pixels of full-width rows, from `firstRow` on, that contain `active` pixels with work left (or all there
  /// are).
  std::uint64_t pixelsHolding(std::uint64_t active, std::uint32_t firstRow) const;
  /// Records that `count` more pixels of the region are finished.
  void finish(const Rect& region, std::uint64_t count);

 private:
  std::uint32_t width_;
  std::vector<double> rows_;
};

}  // namespace candela::device
