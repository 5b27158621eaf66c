// The frame in which a surface scatters, and the choice of a layer of a normal-mapped surface: docs/light-transport.md
// sections 4, 5.8 and 5.12.
#ifndef CANDELA_SHADING_GLSL
#define CANDELA_SHADING_GLSL
#include "anisotropy.glsl"
#include "coat.glsl"
#include "normal_maps.glsl"
#include "normals.glsl"

// A vertex in the local frame of its shading normal.
struct Shading {
  mat3 frame;
  vec3 outward;  // geometric normal with the primitive's own orientation
  vec3 wo;      // local
  bool outside; // wo is on the side of the primitive's own normal
  Facets facets;
  vec3 unmapped;  // Surface::unmapped, local
};

Shading shadingAt(Surface surface, vec3 wo) {
  Normals normals = normalsTowards(surface, wo);
  mat3 frame = kHasAnisotropy ? frameAlong(normals.shading, surface.anisotropyDirection) : frameAround(normals.shading);
  Shading shading = Shading(frame, surface.outward, wo * frame, normals.outside, kNoFacets, vec3(0.0));
  if (kHasFilteredNormals) shading.unmapped = surface.unmapped * frame;
  if (kHasNormalMaps && surface.isMapped) {
    shading.facets = Facets(true, normals.geometric * frame);
    shading.wo = seenByFacet(shading.facets, shading.wo, surface.facet);
  }
  return shading;
}

// Returns the cosine of a direction to the geometric normal on wo's side.
float facingCosine(Shading shading, vec3 direction) {
  float cosine = dot(direction, shading.outward);
  return shading.outside ? cosine : -cosine;
}

// Returns whether the geometric normal classifies a direction as the shading normal does, as reflected or as
// transmitted.
bool keepsSide(Shading shading, vec3 direction, bool transmitted) {
  return (facingCosine(shading, direction) > 0.0) != transmitted;
}

// Applies the normal map of a material or of its coat to the shading normal. If the material has a coat, one layer is
// chosen, and `material` becomes this layer.
void mapLayer(inout Surface surface, inout Material material, vec3 wo, SampleKey key, uint depth) {
  uint index = surface.kind >> kMaterialShift;
  uint base = textureOf(index, kSlotNormal);
  uint coat = kHasCoat ? textureOf(index, kSlotCoatNormal) : 0u;
  if (!hasTangents(surface) || (base | coat) == 0u) return;
  vec4 numbers = facetNumbers(key, depth);
  uvec4 scaleRow = sceneRow(materialTextureRow(index) + kScaleRow);
  vec2 scales = uintBitsToFloat(scaleRow.xy);
  if (kHasCoat && material.surface.coatWeight > 0.0) {
    Surface coated = surface;
    mapNormal(coated, coat, scales.y, scaleRow.z & kNormalMapWithoutFacets, wo);
    coated.facet = numbers.z;
    material.surface.isCoatAlone =
        numbers.y < coatReflectance(material.surface.coatWeight, shadingAt(coated, wo).wo.z);
    if (material.surface.isCoatAlone) {
      surface = coated;
      return;
    }
    material.surface.coatWeight = 0.0;
  }
  mapNormal(surface, base, scales.x, scaleRow.z, wo);
  surface.facet = numbers.x;
  bool hasFacets = (scaleRow.z & kNormalMapWithoutFacets) == 0u;
  if (!hasFacets && dot(surface.shading, wo) * dot(surface.outward, wo) <= 0.0) makeBlack(material);
}

#endif
