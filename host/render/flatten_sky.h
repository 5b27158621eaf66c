// Rows of a sky box.
#pragma once
#include "host/render/flat_rows.h"
#include "host/scene/scene.h"

namespace candela {

/// Face headers, the table of linear values of 8-bit sRGB, and the texels: see shaders/shared/scene_rows.h.
Rows skyRows(const Sky& sky);

}  // namespace candela
