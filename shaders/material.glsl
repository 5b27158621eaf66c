// The material at a point of a surface: docs/light-transport.md section 5.
#ifndef CANDELA_MATERIAL_GLSL
#define CANDELA_MATERIAL_GLSL
#include "primitives.glsl"
#include "scene_access.glsl"

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
  material.mirror = false;
  if (kHasGlossy || kHasMirror || kHasDielectric) {
    vec4 last = sceneRowFloat(row + 3u);
    material.exponent = last.x;
    material.ior = last.y;
    material.mirror = last.z != 0.0;
  }
  material.specular = vec3(0.0);
  if (kHasMirror || kHasDielectric) material.specular = sceneRowFloat(row + 4u).xyz;
  return material;
}

// The only source of what integrators know about a material. It depends on nothing but the surface point.
Material materialAt(Surface surface) { return loadMaterial(surface.kind >> kMaterialShift); }

#endif
