// Reads the material of a surface from its records, without its textures.
#ifndef CANDELA_LOAD_MATERIAL_GLSL
#define CANDELA_LOAD_MATERIAL_GLSL
#include "material_types.glsl"
#include "scene_access.glsl"

uint surfaceRow(uint index) { return constants.firstSurfaceRow + index * kSurfaceRows; }

SurfaceParameters loadSurface(uint index, out uint volume) {
  uint row = surfaceRow(index);
  vec4 base = sceneRowFloat(row);
  vec4 specular = sceneRowFloat(row + 1u);
  vec4 shape = sceneRowFloat(row + 2u);
  float coat = kHasCoat ? sceneRowFloat(row + 3u).w : 0.0;
  volume = kHasVolumes ? sceneRow(row + 4u).x : 0u;
  vec3 anisotropy = kHasAnisotropy ? sceneRowFloat(row + 4u).yzw : vec3(0.0);
  vec4 sheen = kHasSheen ? sceneRowFloat(row + 5u) : vec4(0.0);
  vec4 film = kHasFilm ? sceneRowFloat(row + 6u) : vec4(0.0);
  vec4 eta = kHasConductors ? sceneRowFloat(row + 7u) : vec4(0.0);
  vec4 kappa = kHasConductors || kHasDispersion ? sceneRowFloat(row + 8u) : vec4(0.0);
  return SurfaceParameters(base.xyz, base.w, specular.xyz, specular.w, shape.x, anisotropy.x, anisotropy.yz, shape.y,
                           shape.z, kappa.w, volume == 0u, coat, shape.w, false, false, sheen.xyz, sheen.w, film.x,
                           film.y, film.z, film.w, eta.w != 0.0, eta.xyz, kappa.xyz);
}

// Loads a material by its index in the scene.
Material loadMaterial(uint index) {
  uint row = constants.firstMaterialRow + index * kMaterialRows;
  Material material;
  material.isSurface = false;
  material.volume = 0u;
  material.outside = true;
  material.channel = 1u;
  material.channelProbabilities = vec3(0.0, 1.0, 0.0);
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
  if (kHasGlossy || kHasMirror || kHasDielectric || kHasSurfaces) {
    uvec4 last = sceneRow(row + 3u);
    material.exponent = uintBitsToFloat(last.x);
    material.ior = uintBitsToFloat(last.y);
    material.mirror = uintBitsToFloat(last.z) != 0.0;
    if (kHasSurfaces && last.w != 0u) {
      material.isSurface = true;
      material.surface = loadSurface(last.w - 1u, material.volume);
    }
  }
  material.specular = vec3(0.0);
  if (kHasMirror || kHasDielectric) material.specular = sceneRowFloat(row + 4u).xyz;
  return material;
}

#endif
