// Rows of the compressed eight-wide BVH.
#pragma once
#include "host/accel/wide_bvh.h"
#include "host/flatten/flat_rows.h"

namespace candela::flatten {

/// Appends all nodes, gaps included, as shaders/shared/scene_rows.h lays them out.
void appendWideNodes(const accel::WideBvh& wide, Rows& rows);

}  // namespace candela::flatten
