// Materials that are choices between two others: docs/light-transport.md section 5.16.
#ifndef CANDELA_MATERIAL_CHOICE_GLSL
#define CANDELA_MATERIAL_CHOICE_GLSL
#include "attributes.glsl"
#include "surface_point.glsl"
#include "textures.glsl"

// The number that chooses materials at a vertex of a path.
float materialNumber(SampleKey key, uint depth) {
  return toUnit(sampleGroup(key, vertexGroup(depth, kDimensionBsdfU))).w;
}

// Replaces a material that is a choice by one of its materials. Returns whether it was a choice.
bool takeChoice(inout Surface surface, vec3 direction, float number) {
  uint index = surface.kind >> kMaterialShift;
  uint row = constants.firstMaterialRow + index * kMaterialRows;
  if (sceneRow(row + 3u).w != kMaterialIsChoice) return false;
  uvec4 choice = sceneRow(row);
  float weight = uintBitsToFloat(choice.z);
  bool takesSecond;
  if (weight < 0.0) {
    takesSecond = dot(surface.outward, direction) >= 0.0;
  } else {
    bool isMapped = kHasTextures && (surface.attributes & kGeometryTexCoords) != 0u;
    uint reference = isMapped ? textureOf(index, kSlotBaseColour) : 0u;
    if (reference != 0u) weight *= alphaOf(textureTexel(reference, surface.texCoords, surface.jitter.xy));
    takesSecond = number < weight * surface.alpha;
  }
  uint flags = surface.kind & ((1u << kMaterialShift) - 1u);
  surface.kind = flags | (takesSecond ? choice.y : choice.x) << kMaterialShift;
  return true;
}

// Replaces the material of a surface, at which a ray of this direction arrives, by the one that the ray sees.
void chooseMaterial(inout Surface surface, vec3 direction, float number) {
  if (takeChoice(surface, direction, number)) takeChoice(surface, direction, number);
}

#endif
