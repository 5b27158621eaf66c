// Binned SAH on one range: bins, and the best plane between them.
#include <algorithm>
#include <array>
#include <cmath>

#include "host/trace/accel/split_rules.h"

namespace candela::accel {
namespace {

// Small ranges use fewer bins: three of four ranges have fewer than 8 items, and 4 to 6 bins increase the SAH cost by
// only 0.1 %.
constexpr std::uint32_t kMinBins = 4;
constexpr std::uint32_t kMaxBins = 16;
constexpr std::uint32_t kMaxCoarseBins = 8;

// Maps doubled centres to bins, separately for each axis. The scale is 0 for an axis that is flat or too short to be
// divided, and, with the coarse rule, for all axes but the longest.
struct Binning {
  bool isCoarse;
  int longest;
  std::uint32_t binCount;
  float origin[3];
  float scale[3];

  Binning(const Box4& centres2, std::size_t itemCount, SplitRule rule)
      : isCoarse(rule == SplitRule::coarseSah),
        longest(longestAxis(centres2)),
        binCount(static_cast<std::uint32_t>(
            std::min<std::size_t>(isCoarse ? kMaxCoarseBins : kMaxBins, kMinBins + itemCount / 4))) {
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = centres2.min[axis];
      // Slightly less than binCount, so that the last centre is in the last bin after rounding.
      const float factor = static_cast<float>(binCount) * (1 - 0x1p-20f) / (centres2.max[axis] - origin[axis]);
      scale[axis] = std::isfinite(factor) && (!isCoarse || axis == longest) ? factor : 0;
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
    if (binning.isCoarse) {
      fill<1>(items, binning, binning.longest);
    } else {
      fill<3>(items, binning, 0);
    }
  }

 private:
  template <int kAxes>
  void fill(std::span<const BuildItem> items, const Binning& binning, int firstAxis) {
    for (int axis = firstAxis; axis < firstAxis + kAxes; ++axis) {
      std::fill_n(boxes[axis].begin(), binning.binCount, Box4{});
      std::fill_n(counts[axis].begin(), binning.binCount, 0u);
    }
    for (const BuildItem& item : items) {
      for (int axis = firstAxis; axis < firstAxis + kAxes; ++axis) {
        const std::uint32_t bin = binning.binOf(item, axis);
        boxes[axis][bin].extend(item.box);
        ++counts[axis][bin];
      }
    }
  }
};

// A plane before bin `bin` of `axis`. The cost is the sum of half area times count over both sides.
struct BinPlane {
  int axis = -1;
  std::uint32_t bin = 0;
  std::uint32_t leftCount = 0;
  std::uint32_t imbalance = 0;
  double cost = std::numeric_limits<double>::infinity();

  // If boxes have no area, all costs are 0. The more balanced split is then better.
  bool isBetterThan(const BinPlane& other) const {
    return cost < other.cost || (cost == other.cost && imbalance < other.imbalance);
  }
};

BinPlane bestPlaneOnAxis(const Bins& bins, int axis, std::uint32_t binCount, std::uint32_t itemCount) {
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
  BinPlane best;
  Box4 left;
  std::uint32_t leftCount = 0;
  for (std::uint32_t bin = 1; bin < binCount; ++bin) {
    left.extend(boxes[bin - 1]);
    leftCount += counts[bin - 1];
    // The first and the last bin of an axis that is not flat contain an item each: no side is ever empty.
    const std::uint32_t larger = std::max(leftCount, itemCount - leftCount);
    const BinPlane plane{axis, bin, leftCount, 2 * larger - itemCount, left.halfArea() * leftCount + rightCosts[bin]};
    if (plane.isBetterThan(best)) best = plane;
  }
  return best;
}

BinPlane bestPlane(const Bins& bins, const Binning& binning, std::uint32_t itemCount) {
  BinPlane best;
  for (int axis = 0; axis < 3; ++axis) {
    if (binning.isFlat(axis)) continue;
    const BinPlane plane = bestPlaneOnAxis(bins, axis, binning.binCount, itemCount);
    if (plane.isBetterThan(best)) best = plane;
  }
  return best;
}

// `splitCost` is the sum of half area times count over both sides.
bool leafIsCheaper(double splitCost, const RangeSummary& summary, std::size_t itemCount, const BvhOptions& options) {
  const double area = summary.bounds.halfArea();
  const double asLeaf = double{options.intersectionCost} * area * static_cast<double>(itemCount);
  return asLeaf <= double{options.traversalCost} * area + double{options.intersectionCost} * splitCost;
}

// Two items can be split in only one way. A third of all interior nodes are such pairs.
std::optional<RangeSplit> splitPair(std::span<const BuildItem> items, const RangeSummary& summary,
                                    const BvhOptions& options) {
  const double splitCost = items[0].box.halfArea() + items[1].box.halfArea();
  if (options.maxLeafSize >= 2 && leafIsCheaper(splitCost, summary, 2, options)) return std::nullopt;
  return RangeSplit{1, {summarize(items.first(1)), summarize(items.subspan(1))}};
}

}  // namespace

std::optional<RangeSplit> splitBySah(std::span<BuildItem> items, const RangeSummary& summary, std::uint32_t levels,
                                     const BvhOptions& options) {
  const bool mayBeLeaf = items.size() <= options.maxLeafSize;
  if (items.size() == 2) return splitPair(items, summary, options);
  const auto itemCount = static_cast<std::uint32_t>(items.size());
  const Binning binning(summary.centres2, items.size(), options.rule);
  const BinPlane plane = bestPlane(Bins(items, binning), binning, itemCount);
  if (mayBeLeaf && (plane.axis < 0 || leafIsCheaper(plane.cost, summary, items.size(), options))) return std::nullopt;
  if (plane.axis < 0 || !fitsBelow(plane.leftCount, items.size(), levels, options)) {
    return splitAtMedian(items, summary.centres2);
  }
  return partition(items, [&](const BuildItem& item) { return binning.binOf(item, plane.axis) >= plane.bin; });
}

}  // namespace candela::accel
