// One step of building a BVH: computing the bounds of a range of boxes, choosing a split, and partitioning the range.
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "host/trace/accel/bvh.h"

namespace candela::accel {

/// Four floats in one vector register (an extension of GCC and Clang). Comparisons work lane by lane.
typedef float Float4 __attribute__((vector_size(16)));
inline Float4 min4(Float4 a, Float4 b) { return b < a ? b : a; }
inline Float4 max4(Float4 a, Float4 b) { return b > a ? b : a; }

/// A box in four lanes, empty at first. The value of lane 3 is irrelevant.
struct Box4 {
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Float4 min = {kInfinity, kInfinity, kInfinity, kInfinity};
  Float4 max = {-kInfinity, -kInfinity, -kInfinity, -kInfinity};

  void extend(const Box4& other) {
    min = min4(min, other.min);
    max = max4(max, other.max);
  }
  void extend(Float4 point) {
    min = min4(min, point);
    max = max4(max, point);
  }
  /// Returns half the surface area, in double precision, so that no box within +-2^100 overflows. The box must not be
  /// empty.
  double halfArea() const {
    const double x = double{max[0]} - double{min[0]}, y = double{max[1]} - double{min[1]},
                 z = double{max[2]} - double{min[2]};
    return x * y + (x + y) * z;
  }
  Aabb toAabb() const { return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}}; }
};

/// A box to be partitioned, with its index in the otherwise unused lane: 32 bytes that are moved together.
struct BuildItem {
  Box4 box;

  BuildItem() = default;
  BuildItem(const Aabb& bounds, std::uint32_t index);
  std::uint32_t index() const { return std::bit_cast<std::uint32_t>(box.min[3]); }
  /// Returns twice the centre along `axis`, which has the same order as the centre.
  float centre2(int axis) const { return box.min[axis] + box.max[axis]; }
};
static_assert(sizeof(BuildItem) == 32);

/// The bounds of the boxes of a range, and the bounds of their doubled centres.
struct RangeSummary {
  Box4 bounds;
  Box4 centres2;

  void extend(const Box4& box) {
    bounds.extend(box);
    centres2.extend(box.min + box.max);
  }
};
RangeSummary summarize(std::span<const BuildItem> items);

/// A range split in two: items [0, leftCount) and the others, both not empty, with the bounds of each side.
struct RangeSplit {
  std::size_t leftCount = 0;
  std::array<RangeSummary, 2> sides;
};

/// Returns the minimum number of steps from a node of `itemCount` items to leaves of `maxLeafSize`, by halving.
std::uint32_t levelsNeeded(std::size_t itemCount, std::uint32_t maxLeafSize);

/// Reorders `items` and splits them by options.rule, or returns nothing if they become one leaf. At most `levels` steps
/// may lie below this node. If the split by the rule leaves a side that does not fit below, the range is split at the
/// median, which fits: levelsNeeded(items.size()) <= levels. The result depends only on the order of the items.
std::optional<RangeSplit> splitRange(std::span<BuildItem> items, const RangeSummary& summary, std::uint32_t levels,
                                     const BvhOptions& options);

}  // namespace candela::accel
