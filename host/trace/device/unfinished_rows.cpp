// Estimates the unfinished pixels of the rows of a band.
#include "host/trace/device/unfinished_rows.h"

#include <algorithm>

namespace candela::device {

std::uint64_t UnfinishedRows::activeIn(const Rect& region) const {
  double active = 0;
  for (std::uint32_t y = region.y; y < region.y + region.height; ++y) active += rows_[y];
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(active * region.width / width_));
}

std::uint64_t UnfinishedRows::pixelsHolding(std::uint64_t active, std::uint32_t firstRow) const {
  const auto wanted = static_cast<double>(active);
  double held = 0;
  std::uint32_t end = firstRow;
  while (end < rows_.size() && held + rows_[end] <= wanted) held += rows_[end++];
  return std::max(active, std::uint64_t{end - firstRow} * width_);
}

void UnfinishedRows::finish(const Rect& region, std::uint64_t count) {
  double active = 0;
  for (std::uint32_t y = region.y; y < region.y + region.height; ++y) active += rows_[y];
  if (active <= 0) return;
  const double left = std::max(0.0, 1 - static_cast<double>(count) / active);
  for (std::uint32_t y = region.y; y < region.y + region.height; ++y) rows_[y] *= left;
}

}  // namespace candela::device
