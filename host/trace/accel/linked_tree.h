// A binary BVH whose subtrees can be moved.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/trace/accel/bvh.h"

namespace candela::accel {

/// The move of a subtree next to another node, which is not inside it.
struct SubtreeMove {
  static constexpr std::uint32_t kNowhere = ~0u;
  std::uint32_t from = 0;
  std::uint32_t to = kNowhere;
  double gain = 0;  ///< decrease of the sum of the interior nodes' half areas, >= 0
};

/// The top of a valid BVH, the source, down to subtrees that are not divided. Siblings are adjacent; otherwise nodes
/// have no order. The root is node 0.
class LinkedTree {
 public:
  /// Opens the nodes with the largest surface areas until there are `nodeLimit` nodes, or until all nodes that are not
  /// open are leaves of the source.
  LinkedTree(const Bvh& source, std::size_t nodeLimit);

  /// A node as in a Bvh, except that the `first` of a leaf is the index of the source node that it represents.
  const std::vector<BvhNode>& nodes() const { return nodes_; }
  static std::uint32_t siblingOf(std::uint32_t node) { return ((node - 1) ^ 1) + 1; }
  std::uint32_t parentOf(std::uint32_t node) const { return parents_[(node - 1) / 2]; }
  /// Returns the sum of the interior nodes' half areas: the part of the SAH cost that depends on how the leaves are
  /// joined.
  double innerHalfArea() const;

  /// Returns whether all source nodes below it would be at most `maxDepth` steps from the root.
  bool mayMove(const SubtreeMove& move, std::uint32_t maxDepth) const;
  /// Puts an interior node at the position of move.to, with move.to and move.from as its children. The subtrees at
  /// three nodes change: move.to, and the parent and the sibling of move.from.
  void move(const SubtreeMove& move);

  /// Returns the source in the new order, as a valid BVH.
  Bvh layOut(const Bvh& source) const;

 private:
  void openAll(const Bvh& source);
  void openLargest(const Bvh& source, std::size_t nodeLimit);
  void put(std::uint32_t index, const BvhNode& node, std::uint32_t height);
  void refit(std::uint32_t node);
  void layOut(const Bvh& source, std::uint32_t node, std::uint32_t slot, std::vector<BvhNode>& out) const;

  std::vector<BvhNode> nodes_;
  std::vector<std::uint32_t> parents_;  ///< parent of each pair of siblings
  std::vector<std::uint32_t> heights_;  ///< number of steps to the deepest leaf of the source
};

}  // namespace candela::accel
