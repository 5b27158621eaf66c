// Surfaces that are rougher in one direction: docs/light-transport.md section 5.12.
#pragma once
#include "host/trace/reference/surface.h"
#include "host/trace/reference/surface_material.h"
#include "host/trace/reference/textured_material.h"

namespace candela::reference {

/// Sets the direction in which an anisotropic material is rougher at a surface, and scales its strength by the texture.
/// If the surface has no tangent, the material becomes isotropic.
void alignAnisotropy(const TextureReader& textures, Surface& surface, SurfaceMaterial& material);

}  // namespace candela::reference
