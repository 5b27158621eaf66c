// The midpoint split, and the median split, which is used if the midpoint split would become too deep.
#include <algorithm>
#include <utility>

#include "host/trace/accel/split_rules.h"

namespace candela::accel {
namespace {

double meanCentre2(std::span<const BuildItem> items, int axis) {
  double sum = 0;
  for (const BuildItem& item : items) sum += double{item.centre2(axis)};
  return sum / static_cast<double>(items.size());
}

RangeSplit splitAt(std::span<BuildItem> items, int axis, double plane2) {
  return partition(items, [=](const BuildItem& item) { return double{item.centre2(axis)} >= plane2; });
}

bool isOneSided(const RangeSplit& split, std::size_t itemCount) {
  return split.leftCount == 0 || split.leftCount == itemCount;
}

RangeSplit cutAt(std::span<const BuildItem> items, std::size_t leftCount) {
  return {leftCount, {summarize(items.first(leftCount)), summarize(items.subspan(leftCount))}};
}

}  // namespace

int longestAxis(const Box4& box) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (box.max[i] - box.min[i] > box.max[axis] - box.min[axis]) axis = i;
  }
  return axis;
}

std::optional<RangeSplit> splitAtMidpoint(std::span<BuildItem> items, const RangeSummary& summary, std::uint32_t levels,
                                          const BvhOptions& options) {
  if (items.size() <= options.maxLeafSize) return std::nullopt;
  const int axis = longestAxis(summary.bounds);
  // Planes are doubled, like centres.
  RangeSplit split = splitAt(items, axis, double{summary.bounds.min[axis]} + double{summary.bounds.max[axis]});
  if (isOneSided(split, items.size())) split = splitAt(items, axis, meanCentre2(items, axis));
  if (isOneSided(split, items.size())) split = cutAt(items, std::min<std::size_t>(2, items.size() - 1));
  if (!fitsBelow(split.leftCount, items.size(), levels, options)) return splitAtMedian(items, summary.centres2);
  return split;
}

RangeSplit splitAtMedian(std::span<BuildItem> items, const Box4& centres2) {
  const int axis = longestAxis(centres2);
  const std::size_t half = items.size() / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [axis](const BuildItem& a, const BuildItem& b) {
                     return std::pair(a.centre2(axis), a.index()) < std::pair(b.centre2(axis), b.index());
                   });
  return cutAt(items, half);
}

bool fitsBelow(std::size_t leftCount, std::size_t itemCount, std::uint32_t levels, const BvhOptions& options) {
  return levelsNeeded(std::max(leftCount, itemCount - leftCount), options.maxLeafSize) < levels;
}

}  // namespace candela::accel
