// Computes the bounds of ranges of boxes, and selects the rule that splits them.
#include "host/trace/accel/build_range.h"

#include "host/base/divide_up.h"
#include "host/trace/accel/split_rules.h"

namespace candela::accel {

BuildItem::BuildItem(const Aabb& bounds, std::uint32_t index)
    : box{{bounds.min.x, bounds.min.y, bounds.min.z, std::bit_cast<float>(index)},
          {bounds.max.x, bounds.max.y, bounds.max.z, 0}} {}

RangeSummary summarize(std::span<const BuildItem> items) {
  RangeSummary summary;
  for (const BuildItem& item : items) summary.extend(item.box);
  return summary;
}

std::uint32_t levelsNeeded(std::size_t itemCount, std::uint32_t maxLeafSize) {
  const std::size_t leaves = divideUp<std::size_t>(itemCount, maxLeafSize);
  return leaves <= 1 ? 0 : static_cast<std::uint32_t>(std::bit_width(leaves - 1));
}

std::optional<RangeSplit> splitRange(std::span<BuildItem> items, const RangeSummary& summary, std::uint32_t levels,
                                     const BvhOptions& options) {
  const bool mayBeLeaf = items.size() <= options.maxLeafSize;
  if (items.size() == 1 || (mayBeLeaf && levels == 0)) return std::nullopt;
  if (options.rule == SplitRule::midpoint) return splitAtMidpoint(items, summary, levels, options);
  return splitBySah(items, summary, levels, options);
}

}  // namespace candela::accel
