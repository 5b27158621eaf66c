// Stores a uniform grid as 16-byte records.
#pragma once
#include <cstdint>
#include <vector>

#include "host/accel/primitive_bounds.h"
#include "host/flatten/flat_scene.h"

namespace candela::flatten {

/// Builds the grid over the finite primitives, appends its cells and items to `flat`, and returns the indices of these
/// primitives in the order in which cells first refer to them. Without finite primitives there is no grid.
std::vector<std::uint32_t> appendGrid(const accel::SceneBounds& bounds, float density, std::uint32_t maxSide,
                                      FlatScene& flat);

}  // namespace candela::flatten
