// Stores a sky box as 16-byte records.
#pragma once
#include "host/flatten/flat_rows.h"
#include "host/scene/scene.h"

namespace candela::flatten {

/// Returns the headers of the faces, the table of linear values of 8-bit sRGB, and the texels: see
/// shaders/shared/scene_rows.h.
Rows skyRows(const scene::Sky& sky);

}  // namespace candela::flatten
