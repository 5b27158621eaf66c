// How many pixels of each row of a band still have samples to do, as far as the host can tell.
#pragma once
#include <cstdint>
#include <vector>

#include "host/device/tile_cursor.h"

namespace candela::device {

/// The device reports how many pixels a dispatch finished, not which: they are spread evenly over the dispatch's rows.
class UnfinishedRows {
 public:
  explicit UnfinishedRows(const render::Extent& band)
      : width_(band.width), rows_(band.height, static_cast<double>(band.width)) {}

  /// Pixels of the region that have work left, at least 1.
  std::uint64_t activeIn(const Rect& region) const;
  /// Size in pixels of full-width rows, from `firstRow` on, that hold `active` pixels with work left (or all there
  /// are).
  std::uint64_t pixelsHolding(std::uint64_t active, std::uint32_t firstRow) const;
  /// `count` pixels of the region are finished that were not before.
  void finish(const Rect& region, std::uint64_t count);

 private:
  std::uint32_t width_;
  std::vector<double> rows_;
};

}  // namespace candela::device
