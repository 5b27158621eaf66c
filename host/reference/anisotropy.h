// Surfaces that are rougher in one direction: docs/light-transport.md section 5.12.
#pragma once
#include "host/reference/rounding.h"
#include "host/reference/surface.h"
#include "host/reference/surface_material.h"

namespace candela::reference {

/// Sets the direction in which an anisotropic material is rougher at a surface, and scales its strength by the texture.
/// If the surface has no tangent, the material becomes isotropic. The texel becomes a decision of `rounding`.
void alignAnisotropy(const scene::Scene& scene, Surface& surface, SurfaceMaterial& material, Rounding& rounding);

}  // namespace candela::reference
