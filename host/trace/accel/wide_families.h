// Chooses the descendants of a node of a binary BVH that become its children in an 8-wide BVH.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "host/trace/accel/bvh.h"
#include "host/trace/accel/quantised_boxes.h"

namespace candela::accel {

/// Up to eight descendants of a node that together contain all of its primitives.
struct Family {
  std::array<std::uint32_t, kWideChildren> members{};
  std::uint32_t size = 0;
};

/// The choice that minimises the expected number of 8-wide nodes that a random line through the root visits: Ylitie,
/// Karras and Laine, section 3.1, except that leaves stay those of the binary BVH. The BVH must be valid and outlive
/// this object.
class WideFamilies {
 public:
  explicit WideFamilies(const Bvh& bvh);

  /// Returns the children of the 8-wide node that replaces the interior node `node`.
  Family of(std::uint32_t node) const;

 private:
  // Entry k - 1: expected number of 8-wide nodes visited by a line through the root, if at most k children of an 8-wide
  // node represent the binary node.
  using Costs = std::array<float, kWideChildren - 1>;

  struct Split {
    std::uint32_t left;  ///< number of children for the left of two nodes; the others are for the right one
    float cost;
  };
  Split bestSplit(std::uint32_t pair, std::uint32_t children) const;
  Costs costsOf(const BvhNode& inner, double rootArea) const;
  void choose(std::uint32_t node, std::uint32_t children, Family& family) const;

  const Bvh& bvh_;
  std::vector<Costs> costs_;  ///< by node; 0 for a leaf
};

}  // namespace candela::accel
