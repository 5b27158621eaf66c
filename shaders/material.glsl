// The material at a point of a surface: docs/light-transport.md section 5.
#ifndef CANDELA_MATERIAL_GLSL
#define CANDELA_MATERIAL_GLSL
#include "primitives.glsl"
#include "scene_access.glsl"
#include "textures.glsl"

// The parameters of a surface (docs/light-transport.md section 5.1), with the names of scene::SurfaceParameters.
struct SurfaceParameters {
  vec3 baseColour;
  float metalness;
  vec3 specularColour;
  float specularWeight;
  float roughness;
  float anisotropy;  // strength
  vec2 rotation;     // cosine and sine
  float ior;
  float transmissionWeight;
  float transmissionDispersionScale;
  bool isThinWalled;
  float coatWeight;
  float coatRoughness;
  bool isCoatAlone;   // the layers below the coat do not count
  bool lacksDiffuse;  // the diffuse lobe does not count, only those beside it
  vec3 sheenColour;
  float sheenRoughness;
  float filmWeight;
  float filmIor;
  float filmThickness;         // in nanometres, at a texel of 1
  float filmThicknessMinimum;  // at a texel of 0
  bool isConductor;
  vec3 eta;    // complex index of refraction of a conductor
  vec3 kappa;
};

// A thin film on a dielectric, as seen from one direction: section 5.11.
struct FilmOnGlass {
  float weight;
  vec3 reflectance;
  vec3 absorbed;  // by the dielectric beside the film, at normal incidence: it neither reflects nor transmits this light
};

// The part of a surface that reflects and transmits light: section 5.5.
struct Glass {
  bool isThin;
  float eta;         // index of refraction beyond the surface, relative to wo's side
  vec3 all;          // factor of the microfacets with a reflectance of 1
  vec3 transmitted;  // factor of the microfacets with a transmittance of 1
  vec3 normal;       // reflectance at normal incidence, and its rise to grazing angles
  vec3 grazing;
  vec3 absorbed;     // of FilmOnGlass
};

// The lobes of a surface as seen from one direction: section 5.4.
struct SurfaceLobes {
  vec3 diffuse;         // albedo
  vec3 specular;        // factor of the microfacets at normal incidence
  vec3 grazing;         // factor of (1 - wo.h)^5
  vec2 alpha;           // along x and y
  float diffuseProbability;   // probabilities of the lobes
  float specularProbability;
  float glassProbability;
  Glass glass;
  float coat;           // factor of the coat's microfacets
  float coatAlpha;
  float coatProbability;      // probability of the coat, and the light that it takes from the lobes below
  vec3 sheen;           // factor of the fibres
  float sheenAlpha;
  float sheenLambda;    // masking for wo
  float sheenProbability;     // probability of the sheen
  float belowSheen;     // the light that the sheen leaves for the lobes below
  vec3 conductor;       // factor of conductorReflectance()
  vec3 eta;
  vec3 kappa;
};

struct Material {
  bool isSurface;  // `surface` and `lobes` count, and not the members from `diffuse` on, except for the emission
  SurfaceParameters surface;
  uint volume;         // number of the volume that the surface bounds; 0: none
  SurfaceLobes lobes;  // computed by prepareLobes(); with dispersion, those of `channel`
  bool outside;        // argument of prepareLobes()
  uint channel;        // of the index of refraction by which a direction is sampled
  vec3 channelProbabilities;  // probabilities of the channels
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

void scaleBaseColour(inout Material material, vec3 scale) {
  if (kHasSurfaces) material.surface.baseColour *= scale;
  material.diffuse *= scale;
  material.glossy *= scale;
  material.specular *= scale;
}

// Returns the texel of a slot, or `absent` if the material has no such texture.
uvec2 texelOf(uint material, uint slot, Surface surface, uvec2 absent) {
  uint reference = textureOf(material, slot);
  return reference == 0u ? absent : textureTexel(reference, surface.texCoords, surface.jitter.xy);
}

// Multiplies a colour by the texel of a slot.
void scaleColour(inout vec3 colour, uint material, uint slot, Surface surface) {
  uint reference = textureOf(material, slot);
  if (reference != 0u) colour *= linearColour(textureTexel(reference, surface.texCoords, surface.jitter.xy));
}

void scaleSurface(inout SurfaceParameters parameters, uint index, Surface surface) {
  const uvec2 white = uvec2(0xffffffffu);
  uvec2 metallicRoughness = texelOf(index, kSlotMetallicRoughness, surface, white);
  parameters.roughness *= greenOf(metallicRoughness);
  parameters.metalness *= blueOf(metallicRoughness);
  uint glossiness = textureOf(index, kSlotGlossiness);
  if (glossiness != 0u) {
    float alpha = alphaOf(textureTexel(glossiness, surface.texCoords, surface.jitter.xy));
    parameters.roughness = 1.0 - (1.0 - parameters.roughness) * alpha;
  }
  parameters.specularWeight *= alphaOf(texelOf(index, kSlotSpecular, surface, white));
  if (kHasTransmission) parameters.transmissionWeight *= redOf(texelOf(index, kSlotTransmission, surface, white));
  if (kHasCoat) {
    parameters.coatWeight *= redOf(texelOf(index, kSlotCoat, surface, white));
    parameters.coatRoughness *= greenOf(texelOf(index, kSlotCoatRoughness, surface, white));
  }
  scaleColour(parameters.specularColour, index, kSlotSpecularColour, surface);
  if (kHasSheen) {
    scaleColour(parameters.sheenColour, index, kSlotSheenColour, surface);
    parameters.sheenRoughness *= alphaOf(texelOf(index, kSlotSheenRoughness, surface, white));
  }
  if (kHasFilm) {
    parameters.filmWeight *= redOf(texelOf(index, kSlotFilm, surface, white));
    float thickness = greenOf(texelOf(index, kSlotFilmThickness, surface, white));
    parameters.filmThickness = mix(parameters.filmThicknessMinimum, parameters.filmThickness, thickness);
  }
}

void applyTextures(inout Material material, uint index, Surface surface) {
  uint baseColour = textureOf(index, kSlotBaseColour);
  if (baseColour != 0u) {
    scaleBaseColour(material, linearColour(textureTexel(baseColour, surface.texCoords, surface.jitter.xy)));
  }
  if (kHasSurfaces && material.isSurface) scaleSurface(material.surface, index, surface);
  uint emission = kHasEmission ? textureOf(index, kSlotEmission) : 0u;
  if (emission != 0u) {
    material.emission *= linearColour(textureTexel(emission, surface.texCoords, surface.jitter.xy));
  }
}

// Integrators obtain materials only from this function, which depends only on the surface point.
Material materialAt(Surface surface) {
  uint index = surface.kind >> kMaterialShift;
  Material material = loadMaterial(index);
  if (kHasColours) scaleBaseColour(material, surface.colour);
  if (kHasColours && kHasEmission && (surface.kind & kFlagEmissionColours) != 0u) material.emission *= surface.colour;
  if (kHasTextures && (surface.kind & kFlagTexCoords) != 0u) applyTextures(material, index, surface);
  return material;
}

#endif
