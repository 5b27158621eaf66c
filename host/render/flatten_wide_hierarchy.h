// Rows of the compressed eight-wide BVH.
#pragma once
#include "host/accel/wide_bvh.h"
#include "host/render/flat_rows.h"

namespace candela {

/// Appends all nodes, gaps included, as shaders/shared/scene_rows.h lays them out.
void appendWideNodes(const WideBvh& wide, Rows& rows);

}  // namespace candela
