// The compressed 8-wide BVH of Ylitie, Karras and Laine ("Efficient Incoherent Ray Traversal on GPUs Through Compressed
// Wide BVHs", HPG 2017): 80 bytes per node on a device, less than a quarter of eight boxes in single precision. It is
// independent of primitives.
//
// Two details differ from the paper. Interior children are stored in a block of eight, each at its index in the parent;
// a block and eight bits, one word, then represent the pending nodes. Blocks have gaps where children are leaves, and
// these gaps hold nodes of other blocks. Leaves are encoded by three bits per child at fixed positions instead of a
// byte.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/trace/accel/bvh.h"
#include "host/trace/accel/quantised_boxes.h"

namespace candela::accel {

inline constexpr std::uint32_t kMaxWideLeaf = 3;          ///< maximum number of primitives in a leaf
inline constexpr std::uint32_t kMaxWideNodes = 1u << 24;  ///< maximum number of nodes, including gaps

/// A node. Bit k of a child's index states, as far as the assignment permits, on which side of the node the child lies
/// along axis k. For a ray whose direction is negative on the axes of the bits of `octant`, index ^ octant orders the
/// children from near to far.
struct WideNode {
  QuantisedBoxes boxes;
  std::uint32_t block = 0;     ///< an interior child i is node block + i
  std::uint8_t innerMask = 0;  ///< bit i: child i is an interior node
  /// First primitive of the leaves, which follow each other in the order of the children.
  std::uint32_t firstPrimitive = 0;
  /// Bits 3 i to 3 i + 2: the number of primitives of child i in unary, from the lowest bit.
  std::uint32_t leafMask = 0;
};

/// The root is node 0. Blocks are nearly in depth-first order, except for those near the root. Nodes without a parent
/// are unused.
struct WideBvh {
  std::vector<WideNode> nodes;
  std::vector<std::uint32_t> primitiveIndices;
  std::uint32_t depth = 0;      ///< steps from the root to the deepest node
  std::uint32_t nodeCount = 0;  ///< number of nodes without gaps
};

/// Returns the maximum number of words on the stack of a traversal: a node on the way down leaves one for its siblings,
/// apart from the root, which has none, and the deepest node, below which there is no way.
constexpr std::uint32_t stackWordsOf(const WideBvh& bvh) { return bvh.depth > 1 ? bvh.depth - 1 : 0; }

/// Collapses a valid binary BVH whose leaves have at most kMaxWideLeaf primitives, into the nodes that WideFamilies
/// chooses. Throws InternalError if a leaf is larger, or if there would be more than kMaxWideNodes nodes.
WideBvh collapse(const Bvh& bvh);

/// Returns the first error of an 8-wide BVH over `bounds`, or nothing: every primitive must be in exactly one leaf,
/// every node must have at most one parent, every quantised box must contain its content with the margin that exactness
/// requires, and the depth must be at most `maxDepth`. Safe on any input.
std::optional<std::string> validate(const WideBvh& wide, std::span<const Aabb> bounds, std::uint32_t maxDepth);

}  // namespace candela::accel
