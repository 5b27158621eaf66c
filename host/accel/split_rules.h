// The rules by which a range of boxes is cut in two, and what they share.
#pragma once
#include <optional>
#include <span>

#include "host/accel/build_range.h"

namespace candela::accel {

/// 0 to 2; of equal ones the first.
int longestAxis(const Box4& box);

/// Where binned SAH (Wald 2007) finds it cheapest; nothing where one leaf is cheaper still. With SplitRule::coarseSah
/// bins are fewer, and along the longest axis of the centres alone. At least two items.
std::optional<RangeSplit> splitBySah(std::span<BuildItem> items, const RangeSummary& summary, std::uint32_t levels,
                                     const BvhOptions& options);

/// Across the longest axis of the range's box: at its centre; if that leaves a side without centres, at their mean; if
/// that does too, between the first two items and the rest. Nothing where the items fit into one leaf.
std::optional<RangeSplit> splitAtMidpoint(std::span<BuildItem> items, const RangeSummary& summary, std::uint32_t levels,
                                          const BvhOptions& options);

/// Halves the range: by the centres along their widest axis, or, if all centres coincide, as the items lie.
RangeSplit splitAtMedian(std::span<BuildItem> items, const Box4& centres2);

/// Whether both sides of a cut can still become leaves in the `levels` - 1 steps below it.
bool fitsBelow(std::size_t leftCount, std::size_t itemCount, std::uint32_t levels, const BvhOptions& options);

/// Moves the items that are not `isRight` to the front and sums up both sides on the way; one may stay empty. Which
/// side an item is on cannot be predicted, so nothing branches on it.
template <class IsRight>
RangeSplit partition(std::span<BuildItem> items, IsRight&& isRight) {
  RangeSplit split;
  for (BuildItem& item : items) {
    const bool right = isRight(item);
    const BuildItem moved = item;
    split.sides[right].extend(moved.box);
    item = items[split.leftCount];
    items[split.leftCount] = moved;
    split.leftCount += !right;
  }
  return split;
}

}  // namespace candela::accel
