// Which descendants of a node of a two-wide tree become its children in an eight-wide one.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "host/accel/bvh.h"
#include "host/accel/quantised_boxes.h"

namespace candela::accel {

/// Up to eight descendants of a node that together hold what it holds.
struct Family {
  std::array<std::uint32_t, kWideChildren> members{};
  std::uint32_t size = 0;
};

/// The choice by which a random line that meets the root meets fewest wide nodes: Ylitie, Karras and Laine,
/// section 3.1, but leaves stay those of the two-wide tree. The tree must be valid and outlive this.
class WideFamilies {
 public:
  explicit WideFamilies(const Bvh& bvh);

  /// The children of a wide node in the place of the inner node `node`.
  Family of(std::uint32_t node) const;

 private:
  // Entry k - 1: wide nodes expected to be met by a line that meets the root, where at most k children of a wide node
  // hold what the two-wide node holds.
  using Costs = std::array<float, kWideChildren - 1>;

  struct Share {
    std::uint32_t left;  ///< children that the left of two nodes gets; the right one gets the others
    float cost;
  };
  Share bestShare(std::uint32_t pair, std::uint32_t children) const;
  Costs costsOf(const BvhNode& inner, double rootArea) const;
  void choose(std::uint32_t node, std::uint32_t children, Family& family) const;

  const Bvh& bvh_;
  std::vector<Costs> costs_;  ///< by node; of a leaf 0
};

}  // namespace candela::accel
