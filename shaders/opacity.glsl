// Triangles that rays may pass: docs/light-transport.md section 12.
#ifndef CANDELA_OPACITY_GLSL
#define CANDELA_OPACITY_GLSL
#include "attributes.glsl"
#include "geometry.glsl"
#include "textures.glsl"

const uint kOpacitySeed = 0x6f706163u;

// Returns the key of the decisions of one ray: that of a path's vertex, or the shadow ray from there.
uint opacityKey(SampleKey key, uint depth, bool shadow) {
  return pcg4d(uvec4(key.pixel, key.sampleIndex, 2u * depth + (shadow ? 1u : 0u), key.seed ^ kOpacitySeed)).x;
}

// Returns the probability with which a ray hits a point of a triangle. `jitter` selects the texel of a material that
// blends.
float opacityAt(Attributes attributes, uint kind, vec2 weights, vec2 jitter) {
  uvec4 opacity = sceneRow(materialTextureRow(kind >> kMaterialShift) + kOpacityRow);
  float alpha = uintBitsToFloat(opacity.x);
  float cutoff = uintBitsToFloat(opacity.y);
  if (kHasColours && hasAll(attributes, kGeometryColours)) alpha *= colourAt(attributes, weights).w;
  if (opacity.z != 0u) {
    vec4 texCoords = texCoordsAt(attributes, weights);
    alpha *= cutoff < 0.0 ? alphaOf(textureTexel(opacity.z, texCoords, jitter)) : filteredTexel(opacity.z, texCoords).w;
  }
  return cutoff < 0.0 ? alpha : alpha >= cutoff ? 1.0 : 0.0;
}

// Returns whether a ray hits a triangle that it may pass, at the distance that the intersection test has found.
bool isThere(Ray ray, uint slot, uvec4 rows[3], float t) {
  vec3 position = ray.origin + t * ray.direction;
  vec3 normal;
  vec2 weights = meetTriangle(position, ray.direction, uintBitsToFloat(rows[0].xyz), uintBitsToFloat(rows[1].xyz),
                              uintBitsToFloat(rows[2].xyz), normal);
  vec3 numbers = toUnit(pcg4d(uvec4(ray.opacityKey, indexOf(rows), 0u, 0u))).xyz;
  uint index = kHasInstances ? sceneRow(primitiveRow(slot) + 1u).w : indexOf(rows);  // `rows` may have been placed
  Attributes attributes = attributesOf(rows[0].w, index);
  return numbers.x < opacityAt(attributes, rows[2].w, weights, numbers.yz);
}

#endif
