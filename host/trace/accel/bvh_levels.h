// The boxes of a BVH, level by level, for display.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "host/trace/accel/bvh.h"

namespace candela::accel {

struct LevelBox {
  Aabb bounds;
  std::uint32_t depth;  ///< steps from the root
};

/// Returns all boxes of a valid BVH; or, with a level, the boxes at `level` steps from the root and the leaves above
/// them, which together contain every primitive once. The order is that of the nodes: a box precedes those inside it.
std::vector<LevelBox> levelBoxes(const Bvh& bvh, std::optional<std::uint32_t> level);

}  // namespace candela::accel
