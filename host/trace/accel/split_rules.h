// The rules that split a range of boxes in two, and their common parts.
#pragma once
#include <optional>
#include <span>

#include "host/trace/accel/build_range.h"

namespace candela::accel {

/// Returns the longest axis, 0 to 2; the first of equal ones.
int longestAxis(const Box4& box);

/// Splits by binned SAH (Wald 2007), or returns nothing if one leaf is cheaper. With SplitRule::coarseSah there are
/// fewer bins, only along the longest axis of the centres. Requires at least two items.
std::optional<RangeSplit> splitBySah(std::span<BuildItem> items, const RangeSummary& summary, std::uint32_t levels,
                                     const BvhOptions& options);

/// Splits perpendicular to the longest axis of the box of the range: at its centre; if one side has no centres, at
/// their mean; if that fails too, after the first two items. Returns nothing if the items fit into one leaf.
std::optional<RangeSplit> splitAtMidpoint(std::span<BuildItem> items, const RangeSummary& summary, std::uint32_t levels,
                                          const BvhOptions& options);

/// Halves the range: by the centres along their longest axis, or in the given order if all centres coincide.
RangeSplit splitAtMedian(std::span<BuildItem> items, const Box4& centres2);

/// Returns whether both sides of a split can still become leaves in the `levels` - 1 steps below it.
bool fitsBelow(std::size_t leftCount, std::size_t itemCount, std::uint32_t levels, const BvhOptions& options);

/// Moves the items that are not `isRight` to the front and computes the bounds of both sides; one side may stay empty.
/// The code has no branch on the side of an item, since it cannot be predicted.
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
