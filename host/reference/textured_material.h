// The textures of a material at a point of a surface.
#pragma once
#include <optional>

#include "host/reference/rounding.h"
#include "host/reference/surface.h"
#include "host/reference/surface_material.h"
#include "host/reference/texture.h"

namespace candela::reference {

/// Multiplies the factors of a material by the vertex colour and the texels at the surface point, which become
/// decisions of `rounding`. `material` is that of the surface without textures.
void applyTextures(const scene::Scene& scene, const Surface& surface, SurfaceMaterial& material, Rounding& rounding);

/// Returns the texel of a slot at the surface point, which becomes a decision of `rounding`; nothing without a texture.
std::optional<Texel> texelOf(const scene::Scene& scene, const Surface& surface, scene::TextureSlot slot,
                             Rounding& rounding);

/// Dims the emission of a material with a coat, as it is seen by a ray of this direction.
void dimEmission(const Surface& surface, const dvec3& rayDirection, SurfaceMaterial& material);

/// Returns the factor of the emission at the sampled point of a light that illuminates a surface: the texel of its
/// texture and the vertex colour, if it is a triangle with them, times its opacity and the transmittance of its coat.
/// Texels and opacity become decisions of `rounding`.
dvec3 emissionFactor(const scene::Scene& scene, const LightSample& light, const Surface& lit, Rounding& rounding);

/// Returns the mean of the texels of the emission of a primitive that is a triangle, times the vertex colours that
/// scale it, at the centres of its 64 congruent parts; 1 if there are neither.
dvec3 meanEmissionTexel(const scene::Scene& scene, const scene::Primitive& triangle);

}  // namespace candela::reference
