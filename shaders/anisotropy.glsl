// Surfaces that are rougher in one direction: docs/light-transport.md section 5.12.
#ifndef CANDELA_ANISOTROPY_GLSL
#define CANDELA_ANISOTROPY_GLSL
#include "material.glsl"
#include "sampling.glsl"

// Sets the direction in which an anisotropic material is rougher, and scales its strength by the texture. Where the surface
// has no tangent, the material becomes isotropic.
void alignAnisotropy(inout Surface surface, inout Material material) {
  if (!material.isSurface || material.surface.anisotropy == 0.0) return;
  vec3 tangent = surface.tangent.xyz;
  if (tangent == vec3(0.0)) {
    material.surface.anisotropy = 0.0;
    return;
  }
  vec2 direction = material.surface.rotation;
  uint reference = kHasTextures && (surface.attributes & kGeometryTexCoords) != 0u
                       ? textureOf(surface.kind >> kMaterialShift, kSlotAnisotropy)
                       : 0u;
  if (reference != 0u) {
    uvec2 texel = textureTexel(reference, surface.texCoords, surface.jitter.xy);
    vec2 turn = 2.0 * vec2(redOf(texel), greenOf(texel)) - 1.0;
    direction = mat2(turn, -turn.y, turn.x) * direction;
    material.surface.anisotropy *= blueOf(texel);
  }
  surface.anisotropyDirection =
      unit(direction.x * tangent + direction.y * surface.tangent.w * cross(surface.shading, tangent));
}

// Returns the frame of a normal whose x axis is the projection of a direction; that of the normal alone if the direction is
// 0 or has no projection.
mat3 frameAlong(vec3 normal, vec3 direction) {
  vec3 projected = direction - dot(direction, normal) * normal;
  float squared = dot(projected, projected);
  if (squared < 1e-12) return frameAround(normal);
  vec3 x = projected * (1.0 / sqrt(squared));
  return mat3(x, cross(normal, x), normal);
}

#endif
