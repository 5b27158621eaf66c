// The material at a point of a surface: docs/light-transport.md section 5.
#ifndef CANDELA_MATERIAL_GLSL
#define CANDELA_MATERIAL_GLSL
#include "primitives.glsl"
#include "scene_access.glsl"
#include "textures.glsl"

struct Material {
  vec3 diffuse;
  float diffuseWeight;
  vec3 glossy;
  float glossyWeight;
  vec3 specular;  // colour of the dielectric or mirror lobe
  vec3 emission;
  float dielectricWeight;
  float exponent;
  float ior;
  float untinted;  // the part of the glossy lobe's colour that the base colour's texture does not scale
  bool mirror;
};

// Loads a material by its index in the scene.
Material loadMaterial(uint index) {
  uint row = constants.firstMaterialRow + index * kMaterialRows;
  Material material;
  vec4 diffuse = sceneRowFloat(row);
  material.diffuse = diffuse.xyz;
  material.diffuseWeight = diffuse.w;
  material.glossy = vec3(0.0);
  material.glossyWeight = 0.0;
  if (kHasGlossy) {
    vec4 glossy = sceneRowFloat(row + 1u);
    material.glossy = glossy.xyz;
    material.glossyWeight = glossy.w;
  }
  material.emission = vec3(0.0);
  material.dielectricWeight = 0.0;
  if (kHasEmission || kHasDielectric) {
    vec4 emission = sceneRowFloat(row + 2u);
    material.emission = emission.xyz;
    material.dielectricWeight = emission.w;
  }
  material.exponent = 0.0;
  material.ior = 1.0;
  material.untinted = 0.0;
  material.mirror = false;
  if (kHasGlossy || kHasMirror || kHasDielectric) {
    vec4 last = sceneRowFloat(row + 3u);
    material.exponent = last.x;
    material.ior = last.y;
    material.mirror = last.z != 0.0;
  }
  material.specular = vec3(0.0);
  if (kHasMirror || kHasDielectric || (kHasTextures && kHasGlossy)) {
    vec4 specular = sceneRowFloat(row + 4u);
    material.specular = specular.xyz;
    material.untinted = specular.w;
  }
  return material;
}

void scaleBaseColour(inout Material material, vec3 scale) {
  material.diffuse *= scale;
  material.glossy = (material.glossy - material.untinted) * scale + material.untinted;
  material.specular *= scale;
}

void applyTextures(inout Material material, uint index, Surface surface) {
  uint baseColour = textureOf(index, kSlotBaseColour);
  if (baseColour != 0u) {
    scaleBaseColour(material, linearColour(textureTexel(baseColour, surface.texCoords, surface.jitter.xy)));
  }
  uint emission = kHasEmission ? textureOf(index, kSlotEmission) : 0u;
  if (emission != 0u) {
    material.emission *= linearColour(textureTexel(emission, surface.texCoords, surface.jitter.xy));
  }
}

// The only source of what integrators know about a material. It depends on nothing but the surface point.
Material materialAt(Surface surface) {
  uint index = surface.kind >> kMaterialShift;
  Material material = loadMaterial(index);
  if (kHasTextures && (surface.kind & kFlagTexCoords) != 0u) applyTextures(material, index, surface);
  return material;
}

#endif
