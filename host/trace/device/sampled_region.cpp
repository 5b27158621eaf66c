// Finds the bounding box of a mask.
#include "host/trace/device/sampled_region.h"

#include <algorithm>

namespace candela::device {

SampledRegion sampledRegionOf(BandRows rows, std::uint32_t width, const render::PixelMask& mask) {
  SampledRegion region{{0, 0, width, rows.height}, std::vector<std::uint32_t>(rows.height, width)};
  if (mask.empty()) return region;
  std::vector<std::uint32_t>& selected = region.selectedInRows;
  std::uint32_t left = width, right = 0;
  for (std::uint32_t y = 0; y < rows.height; ++y) {
    selected[y] = 0;
    for (std::uint32_t x = 0; x < width; ++x) {
      if (!mask[std::size_t{width} * (rows.first + y) + x]) continue;
      ++selected[y];
      left = std::min(left, x);
      right = std::max(right, x + 1);
    }
  }
  const auto isUsed = [](std::uint32_t count) { return count > 0; };
  const auto first = std::ranges::find_if(selected, isUsed);
  if (first == selected.end()) return region;
  const auto end = std::ranges::find_if(selected.rbegin(), selected.rend(), isUsed).base();
  region.box = {left, static_cast<std::uint32_t>(first - selected.begin()), right - left,
                static_cast<std::uint32_t>(end - first)};
  selected = std::vector<std::uint32_t>(first, end);
  return region;
}

}  // namespace candela::device
