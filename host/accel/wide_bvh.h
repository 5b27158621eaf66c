// The compressed eight-wide bounding volume hierarchy of Ylitie, Karras and Laine ("Efficient Incoherent Ray Traversal
// on GPUs Through Compressed Wide BVHs", HPG 2017): 80 bytes a node on a device, less than a quarter of what eight
// boxes take in single precision. Knows nothing of primitives.
//
// Two things differ from theirs. Children that are nodes stand in a block of eight, each at the number that it has in
// its parent: then a block and eight bits, one word, say which nodes wait. Where others are leaves the block has gaps,
// in which nodes of other blocks stand. And leaves are told by three bits a child at fixed places instead of a byte.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/accel/bvh.h"
#include "host/accel/quantised_boxes.h"

namespace candela::accel {

inline constexpr std::uint32_t kMaxWideLeaf = 3;          ///< primitives
inline constexpr std::uint32_t kMaxWideNodes = 1u << 24;  ///< with gaps

/// Bit k of a child's number says, as well as the children's places allow, on which side of the node it lies along axis
/// k: for a ray whose direction is negative on the axes of the bits of `octant`, number ^ octant orders them from near
/// to far.
struct WideNode {
  QuantisedBoxes boxes;
  std::uint32_t block = 0;           ///< child i, if it is a node, is node block + i
  std::uint8_t innerMask = 0;        ///< bit i: child i is a node
  std::uint32_t firstPrimitive = 0;  ///< of the leaves together, which follow each other in the order of children
  std::uint32_t leafMask = 0;  ///< bits 3 i to 3 i + 2: as many are set, from the lowest, as child i has primitives
};

/// The root is node 0. Blocks are nearly in depth-first order but for those next to the root; nodes that no parent
/// names are of no account.
struct WideBvh {
  std::vector<WideNode> nodes;
  std::vector<std::uint32_t> primitiveIndices;
  std::uint32_t depth = 0;      ///< steps from the root to the deepest node
  std::uint32_t nodeCount = 0;  ///< without gaps
};

/// Collapses a valid tree whose leaves hold at most kMaxWideLeaf primitives, into the nodes that WideFamilies chooses.
/// Throws InternalError if a leaf is larger, or if there would be more than kMaxWideNodes nodes.
WideBvh collapse(const Bvh& bvh);

/// What is wrong with a wide tree over `bounds`, or nothing: every primitive in exactly one leaf, every node named at
/// most once, every quantised box around what lies in it by the margin that exactness asks for, depth at most
/// `maxDepth`. Safe on any input.
std::optional<std::string> validate(const WideBvh& wide, std::span<const Aabb> bounds, std::uint32_t maxDepth);

}  // namespace candela::accel
