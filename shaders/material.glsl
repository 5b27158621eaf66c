// The material at a point of a surface, with its textures: docs/light-transport.md section 5.
#ifndef CANDELA_MATERIAL_GLSL
#define CANDELA_MATERIAL_GLSL
#include "primitives.glsl"
#include "scene_access.glsl"
#include "textures.glsl"
#include "load_material.glsl"

// Returns whether a surface is a single interface, rough or smooth: docs/light-transport.md section 5.15.
bool isBareInterface(SurfaceParameters s) { return kHasInterfaces && s.plastic.x >= float(kInterfaceSmooth); }
bool isSmoothInterface(SurfaceParameters s) { return kHasInterfaces && s.plastic.x == float(kInterfaceSmooth); }

// Removes all lobes. The emission stays.
void makeBlack(inout Material material) {
  material.isSurface = false;
  material.mirror = false;
  material.diffuseWeight = 0.0;
  material.glossyWeight = 0.0;
  material.dielectricWeight = 0.0;
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
  if (kHasColours && kHasEmission && (surface.attributes & kGeometryEmissionColours) != 0u) material.emission *= surface.colour;
  if (kHasTextures && (surface.attributes & kGeometryTexCoords) != 0u) applyTextures(material, index, surface);
  return material;
}

#endif
