// Materials that are choices between two others: docs/light-transport.md section 5.16.
#pragma once
#include "host/trace/reference/textured_material.h"
#include "host/trace/reference/vertex_numbers.h"

namespace candela::reference {

/// Replaces the material of a surface point by the one that the ray sees which arrived there.
void chooseMaterial(const TextureReader& textures, VertexNumbers u, Surface& surface);

}  // namespace candela::reference
