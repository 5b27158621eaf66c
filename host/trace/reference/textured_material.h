// The textures of a material at a point of a surface.
#pragma once
#include <optional>

#include "host/trace/reference/arithmetic.h"
#include "host/trace/reference/surface.h"
#include "host/trace/reference/surface_material.h"
#include "host/trace/reference/texture.h"

namespace candela::reference {

/// Looks up the textures of a scene.
struct TextureReader {
  const scene::Scene& scene;
  Arithmetic& arithmetic;  ///< computes the coordinates; each texel is a decision

  /// `texture` is not empty. The jitter, two random numbers, selects among neighbouring texels.
  Texel read(const std::optional<scene::TextureReference>& texture, const MeshAttributes& attributes,
             const dvec2& jitter) const;
  /// Returns the derivatives of the red of a texture by its coordinates s and t, interpolated among four texels.
  dvec2 gradientOfRed(const std::optional<scene::TextureReference>& texture, const MeshAttributes& attributes) const;
  /// Returns the channels of a texture, interpolated among four texels unless its filter is `nearest`.
  glm::dvec4 filtered(const std::optional<scene::TextureReference>& texture, const MeshAttributes& attributes) const;
  /// Returns the texel of a slot of the material at a surface point; nothing without a texture.
  std::optional<Texel> at(const Surface& surface, scene::TextureSlot slot) const;
};

/// Multiplies the factors of a material by the vertex colour and the texels at the surface point. `material` is that of
/// the surface without textures.
void applyTextures(const TextureReader& textures, const Surface& surface, SurfaceMaterial& material);

/// Dims the emission of a material with a coat, as it is seen by a ray of this direction.
void dimEmission(const Surface& surface, const dvec3& rayDirection, SurfaceMaterial& material);

/// Returns the factor of the emission at the sampled point of a light that illuminates a surface: the texel of its
/// texture and the vertex colour, if it is a triangle with them, times its opacity, which is a decision, and the
/// transmittance of its coat.
dvec3 emissionFactor(const TextureReader& textures, const LightSample& light, const Surface& lit);

/// Returns the mean of the texels of the emission of a primitive that is a triangle, times the vertex colours that
/// scale it, at the centres of its 64 congruent parts; 1 if there are neither.
dvec3 meanEmissionTexel(const scene::Scene& scene, const scene::Primitive& triangle);

}  // namespace candela::reference
