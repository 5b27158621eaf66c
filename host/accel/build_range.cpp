// Binned SAH on one range: bins, the best plane among them, and the partition at it.
#include "host/accel/build_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace candela {
namespace {

// Small ranges take fewer bins: three of four ranges have less than 8 items, and 4 to 6 bins cost 0.1 % of SAH cost.
constexpr std::uint32_t kMinBins = 4;
constexpr std::uint32_t kMaxBins = 16;

// Maps doubled centres to bins, each axis on its own. A flat axis, or one too short to be divided, has scale 0.
struct Binning {
  std::uint32_t binCount;
  float origin[3];
  float scale[3];

  Binning(const Box4& centres2, std::size_t itemCount)
      : binCount(static_cast<std::uint32_t>(std::min<std::size_t>(kMaxBins, kMinBins + itemCount / 4))) {
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = centres2.min[axis];
      // A little less than binCount, so that the last centre falls into the last bin whatever the rounding.
      const float factor = static_cast<float>(binCount) * (1 - 0x1p-20f) / (centres2.max[axis] - origin[axis]);
      scale[axis] = std::isfinite(factor) ? factor : 0;
    }
  }
  bool isFlat(int axis) const { return scale[axis] == 0; }
  std::uint32_t binOf(const BuildItem& item, int axis) const {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>((item.centre2(axis) - origin[axis]) * scale[axis]));
  }
};

struct Bins {
  std::array<std::array<Box4, kMaxBins>, 3> boxes;
  std::array<std::array<std::uint32_t, kMaxBins>, 3> counts;

  Bins(std::span<const BuildItem> items, const Binning& binning) {
    for (int axis = 0; axis < 3; ++axis) {
      std::fill_n(boxes[axis].begin(), binning.binCount, Box4{});
      std::fill_n(counts[axis].begin(), binning.binCount, 0u);
    }
    for (const BuildItem& item : items) {
      for (int axis = 0; axis < 3; ++axis) {
        const std::uint32_t bin = binning.binOf(item, axis);
        boxes[axis][bin].extend(item.box);
        ++counts[axis][bin];
      }
    }
  }
};

// A plane before bin `bin` of `axis`. The cost is the sum over both sides of half area times count.
struct Plane {
  int axis = -1;
  std::uint32_t bin = 0;
  std::uint32_t leftCount = 0;
  std::uint32_t imbalance = 0;
  double cost = std::numeric_limits<double>::infinity();

  // Where boxes have no area all costs are 0: then the more balanced tree wins.
  bool isBetterThan(const Plane& other) const {
    return cost < other.cost || (cost == other.cost && imbalance < other.imbalance);
  }
};

Plane bestPlaneOnAxis(const Bins& bins, int axis, std::uint32_t binCount, std::uint32_t itemCount) {
  const auto& boxes = bins.boxes[static_cast<std::size_t>(axis)];
  const auto& counts = bins.counts[static_cast<std::size_t>(axis)];
  std::array<double, kMaxBins> rightCosts;
  Box4 right;
  std::uint32_t rightCount = 0;
  for (std::uint32_t bin = binCount - 1; bin > 0; --bin) {
    right.extend(boxes[bin]);
    rightCount += counts[bin];
    rightCosts[bin] = right.halfArea() * rightCount;
  }
  Plane best;
  Box4 left;
  std::uint32_t leftCount = 0;
  for (std::uint32_t bin = 1; bin < binCount; ++bin) {
    left.extend(boxes[bin - 1]);
    leftCount += counts[bin - 1];
    // The first and the last bin of an axis that is not flat hold an item each: no side is ever empty.
    const std::uint32_t larger = std::max(leftCount, itemCount - leftCount);
    const Plane plane{axis, bin, leftCount, 2 * larger - itemCount, left.halfArea() * leftCount + rightCosts[bin]};
    if (plane.isBetterThan(best)) best = plane;
  }
  return best;
}

Plane bestPlane(const Bins& bins, const Binning& binning, std::uint32_t itemCount) {
  Plane best;
  for (int axis = 0; axis < 3; ++axis) {
    if (binning.isFlat(axis)) continue;
    const Plane plane = bestPlaneOnAxis(bins, axis, binning.binCount, itemCount);
    if (plane.isBetterThan(best)) best = plane;
  }
  return best;
}

// Moves the left side's items to the front, and sums up both sides on the way. Which side an item is on cannot be
// predicted, so nothing branches on it.
RangeSplit partitionAt(std::span<BuildItem> items, const Plane& plane, const Binning& binning) {
  RangeSplit split;
  for (BuildItem& item : items) {
    const bool isRight = binning.binOf(item, plane.axis) >= plane.bin;
    const BuildItem moved = item;
    split.sides[isRight].extend(moved.box);
    item = items[split.leftCount];
    items[split.leftCount] = moved;
    split.leftCount += !isRight;
  }
  return split;
}

// Halves the range: by the centres along their widest axis, or, if all centres coincide, as the items lie.
RangeSplit splitAtMedian(std::span<BuildItem> items, const Box4& centres2) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (centres2.max[i] - centres2.min[i] > centres2.max[axis] - centres2.min[axis]) axis = i;
  }
  const std::size_t half = items.size() / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [axis](const BuildItem& a, const BuildItem& b) {
                     return std::pair(a.centre2(axis), a.index()) < std::pair(b.centre2(axis), b.index());
                   });
  return {half, {summarize(items.first(half)), summarize(items.subspan(half))}};
}

// `splitCost` is the sum over both sides of half area times count.
bool leafIsCheaper(double splitCost, const RangeSummary& summary, std::size_t itemCount, const BvhOptions& options) {
  const double area = summary.bounds.halfArea();
  const double asLeaf = double{options.intersectionCost} * area * static_cast<double>(itemCount);
  return asLeaf <= double{options.traversalCost} * area + double{options.intersectionCost} * splitCost;
}

// Two items can be split in one way only. A third of all inner nodes are such pairs.
std::optional<RangeSplit> splitPair(std::span<const BuildItem> items, const RangeSummary& summary,
                                    const BvhOptions& options) {
  const double splitCost = items[0].box.halfArea() + items[1].box.halfArea();
  if (options.maxLeafSize >= 2 && leafIsCheaper(splitCost, summary, 2, options)) return std::nullopt;
  return RangeSplit{1, {summarize(items.first(1)), summarize(items.subspan(1))}};
}

}  // namespace

BuildItem::BuildItem(const Aabb& bounds, std::uint32_t index)
    : box{{bounds.min.x, bounds.min.y, bounds.min.z, std::bit_cast<float>(index)},
          {bounds.max.x, bounds.max.y, bounds.max.z, 0}} {}

RangeSummary summarize(std::span<const BuildItem> items) {
  RangeSummary summary;
  for (const BuildItem& item : items) summary.extend(item.box);
  return summary;
}

std::uint32_t levelsNeeded(std::size_t itemCount, std::uint32_t maxLeafSize) {
  const std::size_t leaves = (itemCount + maxLeafSize - 1) / maxLeafSize;
  return leaves <= 1 ? 0 : static_cast<std::uint32_t>(std::bit_width(leaves - 1));
}

std::optional<RangeSplit> splitRange(std::span<BuildItem> items, const RangeSummary& summary, std::uint32_t levels,
                                     const BvhOptions& options) {
  const bool mayBeLeaf = items.size() <= options.maxLeafSize;
  if (items.size() == 1 || (mayBeLeaf && levels == 0)) return std::nullopt;

  if (items.size() == 2) return splitPair(items, summary, options);
  const auto itemCount = static_cast<std::uint32_t>(items.size());
  const Binning binning(summary.centres2, items.size());
  const Plane plane = bestPlane(Bins(items, binning), binning, itemCount);
  if (mayBeLeaf && (plane.axis < 0 || leafIsCheaper(plane.cost, summary, items.size(), options))) return std::nullopt;
  if (plane.axis < 0) return splitAtMedian(items, summary.centres2);
  const std::uint32_t larger = std::max(plane.leftCount, itemCount - plane.leftCount);
  if (levelsNeeded(larger, options.maxLeafSize) >= levels) return splitAtMedian(items, summary.centres2);
  return partitionAt(items, plane, binning);
}

}  // namespace candela
