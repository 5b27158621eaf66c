// A binary BVH over boxes in double precision, stored depth-first. Nodes are halved at the median or split at the
// midpoint.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/render/settings.h"

namespace candela::reference {

using glm::dvec3;

struct Bounds {
  dvec3 min{std::numeric_limits<double>::infinity()};
  dvec3 max{-std::numeric_limits<double>::infinity()};

  void extend(const Bounds& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
  Bounds padded(double padding) const { return {min - padding, max + padding}; }
};

/// The widening of boundsOf() as a fraction of a box's largest coordinate.
inline constexpr double kWidening = 1e-8;

/// Returns the box of a primitive, widened by far more than the errors of distances in double precision; nothing for a
/// plane.
std::optional<Bounds> boundsOf(const scene::Scene& scene, const scene::Primitive& primitive);

/// A leaf has the items [first, first + count) of Hierarchy::order. An interior node (count 0) is followed by its near
/// child, and its far child is at `first`, where near and far refer to `axis`.
struct Node {
  Bounds bounds;
  std::uint32_t first = 0;
  std::uint16_t count = 0;
  std::uint16_t axis = 0;
};

struct Hierarchy {
  static constexpr std::uint32_t kLeafSize = 4;
  static constexpr std::uint32_t kMidpointLeafSize = 2;
  /// Maximum depth of midpoint splits; below it, nodes are halved. Halving 2^32 items down to leaves takes 31 steps.
  static constexpr std::uint32_t kMidpointDepth = 32;
  static constexpr std::uint32_t kMaxDepth = kMidpointDepth + 31;

  std::vector<Node> nodes;  ///< the root first; empty if there are no items
  std::vector<std::uint32_t> order;
};

/// `order` becomes a permutation of the boxes' indices. BvhSplit::midpoint: at most two items per leaf; nodes are split
/// perpendicular to the longest axis of their box at its centre; if all items' centres are on one side, at the mean of
/// the centres; and if they still are, two items go to the left and the rest to the right.
Hierarchy buildHierarchy(std::span<const Bounds> boxes, render::BvhSplit split = render::BvhSplit::sah);

}  // namespace candela::reference
