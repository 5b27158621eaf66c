// Validates 8-wide BVHs.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>

#include "host/trace/accel/wide_bvh.h"

namespace candela::accel {
namespace {

// Minimum margin of a quantised box; it allows for rounding in double precision. The proof in quantised_boxes.h needs
// 11 / 16.
constexpr double kMinMargin = 0.75 * kPlaneMargin;

struct WideVisit {
  std::uint32_t node;
  std::uint32_t parent;
  std::uint32_t child;
  std::uint32_t depth;
};

class WideBvhValidator {
 public:
  WideBvhValidator(const WideBvh& wide, std::span<const Aabb> bounds, std::uint32_t maxDepth)
      : wide_(wide), bounds_(bounds), maxDepth_(maxDepth) {}

  std::optional<std::string> run() {
    if (wide_.primitiveIndices.size() != bounds_.size()) {
      return fmt::format("{} primitive indices for {} primitives", wide_.primitiveIndices.size(), bounds_.size());
    }
    if (bounds_.empty() || wide_.nodes.empty()) {
      if (bounds_.empty() && wide_.nodes.empty()) return std::nullopt;
      return fmt::format("{} nodes for {} primitives", wide_.nodes.size(), bounds_.size());
    }
    if (auto problem = traverse()) return problem;
    return checkBoxes();
  }

 private:
  // Nodes have one parent, so that the loop ends on any input. Stores the order of nodes, parents first.
  std::optional<std::string> traverse() {
    nodeNamed_.assign(wide_.nodes.size(), false);
    primitiveSeen_.assign(bounds_.size(), false);
    nodeNamed_[0] = true;
    order_ = {{0, 0, 0, 0}};
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const WideVisit visit = order_[i];
      if (visit.depth > maxDepth_)
        return fmt::format("node {} is {} steps deep, the limit is {}", visit.node, visit.depth, maxDepth_);
      if (auto problem = visitChildren(visit)) return problem;
      if (auto problem = visitLeaves(visit.node)) return problem;
    }
    for (std::size_t i = 0; i < primitiveSeen_.size(); ++i) {
      if (!primitiveSeen_[i]) return fmt::format("primitive {} is in no leaf", i);
    }
    if (order_.size() != wide_.nodeCount)
      return fmt::format("{} nodes are reached, but nodeCount is {}", order_.size(), wide_.nodeCount);
    return std::nullopt;
  }

  std::optional<std::string> visitChildren(const WideVisit& visit) {
    const WideNode& node = wide_.nodes[visit.node];
    for (std::uint32_t child = 0; child < kWideChildren; ++child) {
      if ((node.innerMask >> child & 1) == 0) continue;
      if (leafSize(node, child) > 0) return fmt::format("child {} of node {} is both node and leaf", child, visit.node);
      const std::uint64_t childNode = std::uint64_t{node.block} + child;
      if (childNode >= nodeNamed_.size())
        return fmt::format("node {} names node {} of {}", visit.node, childNode, nodeNamed_.size());
      if (nodeNamed_[childNode]) return fmt::format("node {} is named twice", childNode);
      nodeNamed_[childNode] = true;
      order_.push_back({static_cast<std::uint32_t>(childNode), visit.node, child, visit.depth + 1});
    }
    return std::nullopt;
  }

  std::optional<std::string> visitLeaves(std::uint32_t index) {
    const WideNode& node = wide_.nodes[index];
    if (node.leafMask >> (3 * kWideChildren) != 0) return fmt::format("node {} has leaves beyond its children", index);
    std::uint64_t next = node.firstPrimitive;
    for (std::uint32_t child = 0; child < kWideChildren; ++child) {
      const std::uint32_t bits = node.leafMask >> (3 * child) & 7;
      if (bits != (1u << leafSize(node, child)) - 1) return fmt::format("leaf {} of node {} has gaps", child, index);
      for (std::uint32_t i = 0; i < leafSize(node, child); ++i, ++next) {
        if (next >= bounds_.size())
          return fmt::format("node {} holds primitives up to {} of {}", index, next, bounds_.size());
        const std::uint32_t primitive = wide_.primitiveIndices[next];
        if (primitive >= bounds_.size()) return fmt::format("node {} names primitive {}", index, primitive);
        if (primitiveSeen_[primitive]) return fmt::format("primitive {} is in two leaves", primitive);
        primitiveSeen_[primitive] = true;
      }
    }
    return std::nullopt;
  }

  // Compares the content of each child with its quantised box, from the leaves up.
  std::optional<std::string> checkBoxes() {
    std::vector<std::array<Aabb, kWideChildren>> contents(wide_.nodes.size());
    for (std::size_t i = order_.size(); i-- > 0;) {
      const WideVisit& visit = order_[i];
      std::array<Aabb, kWideChildren>& children = contents[visit.node];
      addLeaves(wide_.nodes[visit.node], children);
      Aabb all;
      for (const Aabb& box : children) all.extend(box);
      for (std::uint32_t child = 0; child < kWideChildren; ++child) {
        if (children[child].isEmpty() || holds(wide_.nodes[visit.node].boxes, child, children[child], all)) continue;
        return fmt::format("child {} of node {} reaches out of its quantised box", child, visit.node);
      }
      if (i > 0) contents[visit.parent][visit.child] = all;
    }
    return std::nullopt;
  }

  void addLeaves(const WideNode& node, std::array<Aabb, kWideChildren>& children) const {
    std::uint32_t next = node.firstPrimitive;
    for (std::uint32_t child = 0; child < kWideChildren; ++child) {
      for (std::uint32_t i = 0; i < leafSize(node, child); ++i) {
        children[child].extend(bounds_[wide_.primitiveIndices[next++]]);
      }
    }
  }

  static bool holds(const QuantisedBoxes& boxes, std::uint32_t child, const Aabb& content, const Aabb& all) {
    for (int axis = 0; axis < 3; ++axis) {
      const double margin = kMinMargin * std::max(std::abs(double{all.min[axis]}), std::abs(double{all.max[axis]}));
      if (boxes.plane(axis, boxes.low[axis][child]) > content.min[axis] - margin) return false;
      if (boxes.plane(axis, boxes.high[axis][child]) < content.max[axis] + margin) return false;
    }
    return true;
  }

  static std::uint32_t leafSize(const WideNode& node, std::uint32_t child) {
    return static_cast<std::uint32_t>(std::popcount(node.leafMask >> (3 * child) & 7));
  }

  const WideBvh& wide_;
  std::span<const Aabb> bounds_;
  std::uint32_t maxDepth_;
  std::vector<WideVisit> order_;
  std::vector<bool> nodeNamed_;
  std::vector<bool> primitiveSeen_;
};

}  // namespace

std::optional<std::string> validate(const WideBvh& wide, std::span<const Aabb> bounds, std::uint32_t maxDepth) {
  return WideBvhValidator(wide, bounds, maxDepth).run();
}

}  // namespace candela::accel
