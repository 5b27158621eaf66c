// Stores a compressed 8-wide BVH as 16-byte records.
#pragma once
#include "host/accel/wide_bvh.h"
#include "host/flatten/flat_rows.h"

namespace candela::flatten {

/// Appends all nodes, gaps included, in the layout of shaders/shared/scene_rows.h.
void appendWideNodes(const accel::WideBvh& wide, Rows& rows);

}  // namespace candela::flatten
