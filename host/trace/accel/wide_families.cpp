// Computes costs from the leaves up, and choices from the root down.
#include "host/trace/accel/wide_families.h"

#include <algorithm>
#include <limits>

namespace candela::accel {
namespace {

// Lower bound on the hit probability of a node. It makes fewer nodes better where nodes have no area.
constexpr double kMinHitProbability = 0x1p-40;

}  // namespace

WideFamilies::WideFamilies(const Bvh& bvh) : bvh_(bvh), costs_(bvh.nodes.size()) {
  const double rootArea = bvh.nodes.front().bounds.surfaceArea();
  // Children follow their parents, so that the loop runs backwards.
  for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
    if (!bvh.nodes[i].isLeaf()) costs_[i] = costsOf(bvh.nodes[i], rootArea);
  }
}

WideFamilies::Split WideFamilies::bestSplit(std::uint32_t pair, std::uint32_t children) const {
  constexpr auto kMaxSamples = static_cast<std::uint32_t>(std::tuple_size_v<Costs>);
  const Costs& left = costs_[pair];
  const Costs& right = costs_[pair + 1];
  Split best{0, std::numeric_limits<float>::infinity()};
  for (std::uint32_t k = children > kMaxSamples ? children - kMaxSamples : 1; k <= std::min(children - 1, kMaxSamples);
       ++k) {
    const float cost = left[k - 1] + right[children - k - 1];
    if (cost < best.cost) best = {k, cost};
  }
  return best;
}

WideFamilies::Costs WideFamilies::costsOf(const BvhNode& inner, double rootArea) const {
  const double hitProbability = rootArea > 0 ? std::max(inner.bounds.surfaceArea() / rootArea, kMinHitProbability) : 1;
  Costs costs;
  costs[0] = static_cast<float>(hitProbability) + bestSplit(inner.first, kWideChildren).cost;
  for (std::uint32_t k = 2; k <= costs.size(); ++k) {
    costs[k - 1] = std::min(costs[k - 2], bestSplit(inner.first, k).cost);
  }
  return costs;
}

Family WideFamilies::of(std::uint32_t node) const {
  Family family;
  const std::uint32_t pair = bvh_.nodes[node].first;
  const std::uint32_t left = bestSplit(pair, kWideChildren).left;
  choose(pair, left, family);
  choose(pair + 1, kWideChildren - left, family);
  return family;
}

// The recursion ends when one child is left: after at most seven steps.
void WideFamilies::choose(std::uint32_t node, std::uint32_t children, Family& family) const {
  const Costs& costs = costs_[node];
  while (children > 1 && costs[children - 1] == costs[children - 2]) --children;
  if (children == 1) {
    family.members[family.size++] = node;
    return;
  }
  const std::uint32_t pair = bvh_.nodes[node].first;
  const std::uint32_t left = bestSplit(pair, children).left;
  choose(pair, left, family);
  choose(pair + 1, children - left, family);
}

}  // namespace candela::accel
