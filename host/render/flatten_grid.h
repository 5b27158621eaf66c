// Rows of the uniform grid.
#pragma once
#include <cstdint>

#include "host/accel/primitive_bounds.h"
#include "host/render/flat_scene.h"

namespace candela {

/// Builds the grid over the finite primitives, whose slots are in their order, and appends its cells and items to
/// `flat`. Without finite primitives there is none.
void appendGrid(const SceneBounds& bounds, float density, std::uint32_t maxSide, FlatScene& flat);

}  // namespace candela
