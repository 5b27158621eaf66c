// The reflectance of coats: docs/light-transport.md section 5.7.
#ifndef CANDELA_COAT_GLSL
#define CANDELA_COAT_GLSL
#include "material.glsl"
#include "microfacets.glsl"

// `cosine`: to the normal of the coat, at least 0.
float coatReflectance(float weight, float cosine) {
  return weight * (0.04 + 0.96 * fifthPower(1.0 - min(cosine, 1.0)));
}

// Returns the weight of the coat at a point of a primitive, 0 if it has none.
float coatWeightAt(uint kind, Attributes attributes, vec2 weights, vec2 jitter) {
  uint material = kind >> kMaterialShift;
  uint surface = sceneRow(constants.firstMaterialRow + material * kMaterialRows + 3u).w;
  if (surface == 0u) return 0.0;
  float weight = loadCoat(surface - 1u).coatWeight;
  uint reference = kHasTextures && hasAll(attributes, kGeometryTexCoords) ? textureOf(material, kSlotCoat) : 0u;
  if (reference == 0u) return weight;
  return weight * redOf(textureTexel(reference, texCoordsAt(attributes, weights), jitter));
}

#endif
