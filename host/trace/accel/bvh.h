// Binary bounding volume hierarchies over boxes, independent of primitives and of the layout on a device.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/trace/accel/bounds.h"

namespace candela::accel {

enum class SplitRule {
  binnedSah,  ///< the split with minimum cost by the surface area heuristic (Wald 2007)
  coarseSah,  ///< the same with half of the bins, along one axis
  midpoint,   ///< the centre of the longest axis, see splitAtMidpoint()
};

/// The nodes of a built BVH that are moved to better positions, see reinsert().
enum class Reinsertion {
  none,
  trunk,  ///< only some thousand nodes with the largest surface areas
  all,
};

struct BvhOptions {
  SplitRule rule = SplitRule::binnedSah;
  Reinsertion reinsertion = Reinsertion::none;
  std::uint32_t maxLeafSize = 4;  ///< maximum number of primitives in a leaf, >= 1
  std::uint32_t maxDepth = 60;    ///< maximum number of steps from the root to a leaf
  float traversalCost = 1;        ///< cost of one step at an interior node, > 0
  float intersectionCost = 1;     ///< cost of one primitive test, > 0
  std::uint32_t threads = 0;      ///< 0: one per core; the BVH does not depend on it
};

/// Interior node: count = 0, children at `first` and `first + 1`, both greater than the node's own index. Leaf: count
/// >= 1 entries of Bvh::primitiveIndices, starting at `first`.
struct BvhNode {
  Aabb bounds;
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  bool isLeaf() const { return count > 0; }
  bool operator==(const BvhNode&) const = default;
};
static_assert(sizeof(BvhNode) == 32);

/// The root is node 0; siblings are adjacent and subtrees contiguous, in depth-first order. There are no nodes if there
/// are no primitives.
struct Bvh {
  std::vector<BvhNode> nodes;
  std::vector<std::uint32_t> primitiveIndices;  ///< a permutation of 0 .. bounds.size() - 1

  bool operator==(const Bvh&) const = default;
};

/// Builds a BVH. Boxes must be finite, not empty (points and flat boxes are permitted) and within +-2^100; at most 2^31
/// of them. Throws InternalError with the values if a box or an option is outside its range, or if maxDepth is too
/// small for any BVH with maxLeafSize primitives per leaf.
Bvh buildBvh(std::span<const Aabb> bounds, const BvhOptions& options = {});

struct BvhQuality {
  double sahCost = 0;       ///< expected cost of a random line that hits the root, in the units of BvhOptions' costs
  std::uint32_t depth = 0;  ///< maximum number of steps from the root to a leaf; 0 for a single leaf
  std::uint32_t nodeCount = 0;
  std::uint32_t leafCount = 0;
  double averageLeafSize = 0;  ///< mean number of primitives in a leaf
  std::uint32_t maxLeafSize = 0;
};
/// Computes the quality of a valid BVH. Only the costs of `options` are used.
BvhQuality quality(const Bvh& bvh, const BvhOptions& options = {});

/// Returns the first error of a BVH over `bounds`, or nothing: every primitive must be in exactly one leaf, every node
/// must be reached once, children and primitives must be inside their parents, and depth and leaf sizes within
/// `options`. Safe on any input.
std::optional<std::string> validate(const Bvh& bvh, std::span<const Aabb> bounds, const BvhOptions& options = {});

}  // namespace candela::accel
