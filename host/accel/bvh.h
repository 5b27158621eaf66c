// Binary bounding volume hierarchies over boxes. Knows nothing of primitives or of any device's layout.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/accel/bounds.h"

namespace candela::accel {

enum class SplitRule {
  binnedSah,  ///< where the surface area heuristic (Wald 2007) finds it cheapest
  coarseSah,  ///< the same with half the bins, along one axis
  midpoint,   ///< the path-tracing report's: the centre of the longest axis, see splitAtMidpoint()
};

/// Which nodes of a built tree are put into better places: see reinsert().
enum class Reinsertion {
  none,
  trunk,  ///< some thousand, of the largest surfaces
  all,
};

struct BvhOptions {
  SplitRule rule = SplitRule::binnedSah;
  Reinsertion reinsertion = Reinsertion::none;
  std::uint32_t maxLeafSize = 4;  ///< primitives in a leaf, >= 1; never exceeded
  std::uint32_t maxDepth = 60;    ///< steps from the root to the deepest leaf; never exceeded
  float traversalCost = 1;        ///< of one step at an inner node, > 0
  float intersectionCost = 1;     ///< of one primitive test, > 0
  std::uint32_t threads = 0;      ///< 0: one per core. The tree does not depend on it
};

/// Inner node: count = 0, children at `first` and `first + 1`, both above the node's own index.
/// Leaf: count >= 1 entries of Bvh::primitiveIndices from `first` on.
struct BvhNode {
  Aabb bounds;
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  bool isLeaf() const { return count > 0; }
  bool operator==(const BvhNode&) const = default;
};
static_assert(sizeof(BvhNode) == 32);

/// The root is node 0; siblings are adjacent and subtrees contiguous, in depth-first order. No nodes if there are no
/// primitives.
struct Bvh {
  std::vector<BvhNode> nodes;
  std::vector<std::uint32_t> primitiveIndices;  ///< a permutation of 0 .. bounds.size() - 1

  bool operator==(const Bvh&) const = default;
};

/// Boxes are finite, not empty (points and flat boxes are fine), and within +-2^100; at most 2^31 of them.
/// Throws InternalError where that, or an option's range, is violated, naming the values; also where maxDepth is too
/// small for any tree of maxLeafSize primitives a leaf.
Bvh buildBvh(std::span<const Aabb> bounds, const BvhOptions& options = {});

struct BvhQuality {
  double sahCost = 0;       ///< expected cost of a random line that meets the root, in the units of BvhOptions' costs
  std::uint32_t depth = 0;  ///< steps from the root to the deepest leaf; 0 for a single leaf
  std::uint32_t nodeCount = 0;
  std::uint32_t leafCount = 0;
  double averageLeafSize = 0;  ///< primitives
  std::uint32_t maxLeafSize = 0;
};
/// Of a valid tree. Only the costs of `options` are read.
BvhQuality quality(const Bvh& bvh, const BvhOptions& options = {});

/// What is wrong with a tree over `bounds`, or nothing: every primitive in exactly one leaf, every node reached once,
/// children and primitives inside their parents, depth and leaf sizes within `options`. Safe on any input.
std::optional<std::string> validate(const Bvh& bvh, std::span<const Aabb> bounds, const BvhOptions& options = {});

}  // namespace candela::accel
