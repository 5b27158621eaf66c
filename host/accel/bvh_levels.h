// The boxes of a tree, level by level, for looking at it.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "host/accel/bvh.h"

namespace candela::accel {

struct LevelBox {
  Aabb bounds;
  std::uint32_t depth;  ///< steps from the root
};

/// All boxes of a valid tree or, with a level, those `level` steps from the root and the leaves above them, which
/// together hold every primitive once. In the tree's order: a box comes before those in it.
std::vector<LevelBox> levelBoxes(const Bvh& bvh, std::optional<std::uint32_t> level);

}  // namespace candela::accel
