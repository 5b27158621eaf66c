// Computes the quality of finished BVHs, and validates them.
#include <fmt/format.h>

#include "host/trace/accel/bvh.h"

namespace candela::accel {
namespace {

struct BvhVisit {
  std::uint32_t node;
  std::uint32_t depth;
};

class BvhValidator {
 public:
  BvhValidator(const Bvh& bvh, std::span<const Aabb> bounds, const BvhOptions& options)
      : bvh_(bvh), bounds_(bounds), options_(options) {}

  std::optional<std::string> run() {
    if (bvh_.primitiveIndices.size() != bounds_.size()) {
      return fmt::format("{} primitive indices for {} primitives", bvh_.primitiveIndices.size(), bounds_.size());
    }
    if (bounds_.empty()) {
      if (bvh_.nodes.empty()) return std::nullopt;
      return fmt::format("{} nodes for no primitives", bvh_.nodes.size());
    }
    if (bvh_.nodes.empty()) return fmt::format("no nodes for {} primitives", bounds_.size());
    return traverse();
  }

 private:
  // Children follow their parent and are reached once, so that the loop ends on any input.
  std::optional<std::string> traverse() {
    std::size_t reached = 0;
    nodeReached_.assign(bvh_.nodes.size(), false);
    primitiveSeen_.assign(bounds_.size(), false);
    stack_ = {{0, 0}};
    while (!stack_.empty()) {
      const BvhVisit visit = stack_.back();
      stack_.pop_back();
      if (nodeReached_[visit.node]) return fmt::format("node {} is reached twice", visit.node);
      nodeReached_[visit.node] = true;
      ++reached;
      if (visit.depth > options_.maxDepth) {
        return fmt::format("node {} is {} steps deep, the limit is {}", visit.node, visit.depth, options_.maxDepth);
      }
      const auto problem = bvh_.nodes[visit.node].isLeaf() ? checkLeaf(visit.node) : checkInner(visit);
      if (problem) return problem;
    }
    if (reached != bvh_.nodes.size()) return fmt::format("{} of {} nodes are reached", reached, bvh_.nodes.size());
    for (std::size_t i = 0; i < primitiveSeen_.size(); ++i) {
      if (!primitiveSeen_[i]) return fmt::format("primitive {} is in no leaf", i);
    }
    return std::nullopt;
  }

  std::optional<std::string> checkInner(const BvhVisit& visit) {
    const BvhNode& node = bvh_.nodes[visit.node];
    if (node.first <= visit.node || node.first >= bvh_.nodes.size() - 1) {
      return fmt::format("node {} of {} has its children at {}", visit.node, bvh_.nodes.size(), node.first);
    }
    for (std::uint32_t child = node.first; child < node.first + 2; ++child) {
      if (!node.bounds.contains(bvh_.nodes[child].bounds)) {
        return fmt::format("node {} reaches out of its parent {}", child, visit.node);
      }
      stack_.push_back({child, visit.depth + 1});
    }
    return std::nullopt;
  }

  std::optional<std::string> checkLeaf(std::uint32_t index) {
    const BvhNode& leaf = bvh_.nodes[index];
    if (leaf.count > options_.maxLeafSize) {
      return fmt::format("leaf {} holds {} primitives, the limit is {}", index, leaf.count, options_.maxLeafSize);
    }
    if (leaf.first >= bounds_.size() || leaf.count > bounds_.size() - leaf.first) {
      return fmt::format("leaf {} holds {} from {} on, of {}", index, leaf.count, leaf.first, bounds_.size());
    }
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const std::uint32_t primitive = bvh_.primitiveIndices[i];
      if (primitive >= bounds_.size()) return fmt::format("leaf {} names primitive {}", index, primitive);
      if (primitiveSeen_[primitive]) return fmt::format("primitive {} is in two leaves", primitive);
      primitiveSeen_[primitive] = true;
      if (!leaf.bounds.contains(bounds_[primitive])) {
        return fmt::format("primitive {} reaches out of leaf {}", primitive, index);
      }
    }
    return std::nullopt;
  }

  const Bvh& bvh_;
  std::span<const Aabb> bounds_;
  const BvhOptions& options_;
  std::vector<BvhVisit> stack_;
  std::vector<bool> nodeReached_;
  std::vector<bool> primitiveSeen_;
};

}  // namespace

std::optional<std::string> validate(const Bvh& bvh, std::span<const Aabb> bounds, const BvhOptions& options) {
  return BvhValidator(bvh, bounds, options).run();
}

BvhQuality quality(const Bvh& bvh, const BvhOptions& options) {
  BvhQuality result;
  if (bvh.nodes.empty()) return result;
  const double rootArea = bvh.nodes[0].bounds.surfaceArea();
  std::vector<BvhVisit> stack = {{0, 0}};
  while (!stack.empty()) {
    const BvhVisit visit = stack.back();
    stack.pop_back();
    const BvhNode& node = bvh.nodes[visit.node];
    // If the root has no area, every node is assumed to be hit.
    const double hitProbability = rootArea > 0 ? node.bounds.surfaceArea() / rootArea : 1;
    ++result.nodeCount;
    result.depth = std::max(result.depth, visit.depth);
    if (node.isLeaf()) {
      ++result.leafCount;
      result.maxLeafSize = std::max(result.maxLeafSize, node.count);
      result.sahCost += hitProbability * double{options.intersectionCost} * node.count;
      continue;
    }
    result.sahCost += hitProbability * double{options.traversalCost};
    for (std::uint32_t child : {node.first, node.first + 1}) stack.push_back({child, visit.depth + 1});
  }
  result.averageLeafSize = static_cast<double>(bvh.primitiveIndices.size()) / result.leafCount;
  return result;
}

}  // namespace candela::accel
