// Bump maps, normal maps of heights: docs/light-transport.md section 5.8.
#pragma once
#include <optional>

#include "host/trace/reference/textured_material.h"

namespace candela::reference {

/// Returns the normal, of any length, of the surface that the heights of its normal map displace, on the side of
/// smoothNormal. Nothing without such a map, and where the triangle has no derivatives by the coordinates.
std::optional<dvec3> bumpedNormal(const TextureReader& textures, const Surface& surface);

}  // namespace candela::reference
