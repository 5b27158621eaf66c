// A two-wide tree whose subtrees can be moved, for improving what a builder has made.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/accel/bvh.h"

namespace candela::accel {

/// A subtree to be taken out and put back beside another node, which may lie anywhere but within it.
struct SubtreeMove {
  static constexpr std::uint32_t kNowhere = ~0u;
  std::uint32_t from = 0;
  std::uint32_t to = kNowhere;
  double gain = 0;  ///< by how much the sum of the inner nodes' half areas falls, >= 0
};

/// The top of a valid tree, the source, down to nodes that stay whole. Siblings are adjacent, nodes otherwise in no
/// order; the root is node 0.
class LinkedTree {
 public:
  /// Opens the nodes of the largest surfaces until there are `nodeLimit`, or no leaves of the source are left closed.
  LinkedTree(const Bvh& source, std::size_t nodeLimit);

  /// As in a Bvh, but a leaf's `first` is the number of the node of the source that it stands for.
  const std::vector<BvhNode>& nodes() const { return nodes_; }
  static std::uint32_t siblingOf(std::uint32_t node) { return ((node - 1) ^ 1) + 1; }
  std::uint32_t parentOf(std::uint32_t node) const { return parents_[(node - 1) / 2]; }
  /// Sum of the inner nodes' half areas: what of a tree's SAH cost depends on how its leaves are joined.
  double innerHalfArea() const;

  /// Whether all nodes of the source below it would be at most `maxDepth` steps from the root.
  bool mayMove(const SubtreeMove& move, std::uint32_t maxDepth) const;
  /// Puts an inner node into the place of move.to, above it and move.from. Three places get other subtrees: move.to,
  /// and the parent and the sibling of move.from.
  void move(const SubtreeMove& move);

  /// The source in this order: a valid tree.
  Bvh layOut(const Bvh& source) const;

 private:
  void openAll(const Bvh& source);
  void openLargest(const Bvh& source, std::size_t nodeLimit);
  void put(std::uint32_t place, const BvhNode& node, std::uint32_t height);
  void refit(std::uint32_t node);
  void layOut(const Bvh& source, std::uint32_t node, std::uint32_t slot, std::vector<BvhNode>& out) const;

  std::vector<BvhNode> nodes_;
  std::vector<std::uint32_t> parents_;  ///< of each pair of siblings
  std::vector<std::uint32_t> heights_;  ///< steps to the deepest leaf of the source
};

}  // namespace candela::accel
