// Reads the material of a surface from its records, without its textures.
#ifndef CANDELA_LOAD_MATERIAL_GLSL
#define CANDELA_LOAD_MATERIAL_GLSL
#include "material_types.glsl"
#include "scene_access.glsl"

uint surfaceRow(uint index) { return constants.firstSurfaceRow + index * kSurfaceRows; }

// Returns the parameters whose lanes are entries of CANDELA_SURFACE_PARAMETERS; the others are not set.
SurfaceParameters unpackSurface(SurfaceRecords records) {
  SurfaceParameters s;
#define UNPACK_COLOUR(name, value, record) s.name = records.record.xyz;
#define UNPACK_NUMBER(name, value, record, lane) s.name = records.record.lane;
#define UNPACK_FLAG(name, value)
  CANDELA_SURFACE_PARAMETERS(UNPACK_COLOUR, UNPACK_NUMBER, UNPACK_FLAG)
#undef UNPACK_COLOUR
#undef UNPACK_NUMBER
#undef UNPACK_FLAG
  return s;
}

// Returns the parameters of the coat and of the volume of a surface; the others are not set.
SurfaceParameters loadCoat(uint index) {
  SurfaceRecords records;
  records.coat = sceneRowFloat(surfaceRow(index) + kSurfaceCoat);
  return unpackSurface(records);
}

SurfaceParameters loadSurface(uint index, out uint volume) {
  uint row = surfaceRow(index);
  SurfaceRecords records;
#define LOAD_RECORD(record, name, index, isLoaded) records.record = isLoaded ? sceneRowFloat(row + name) : vec4(0.0);
  CANDELA_SURFACE_RECORDS(LOAD_RECORD)
#undef LOAD_RECORD
  SurfaceParameters s = unpackSurface(records);
  volume = kHasVolumes ? sceneRow(row + kSurfaceDirection).x : 0u;
  s.isThinWalled = volume == 0u;
  s.rotation = records.direction.zw;
  s.isCoatAlone = false;
  s.lacksDiffuse = false;
  s.isConductor = records.eta.w != 0.0;
  s.eta = records.eta.xyz;
  s.kappa = records.kappa.xyz;
  s.plastic = records.plastic;
  return s;
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
