// Pictures of what camera rays hit instead of radiance: docs/light-transport.md section 10.
#ifndef CANDELA_VIEWS_GLSL
#define CANDELA_VIEWS_GLSL
#include "albedo.glsl"
#include "path.glsl"

vec3 indexColour(uint index) { return vec3((pcg4d(uvec4(index, 0u, 0u, 0u)).xyz >> 24) + 1u) * (1.0 / 256.0); }

// Returns 1 if this sample's ray into the hemisphere hits nothing within constants.aoDistance, else 0.
float openness(Surface surface, Normals normals, SampleKey key, inout Work work, inout RayCounts counts,
               inout Decisions decisions) {
  vec2 numbers = toUnit(sampleGroup(key, vertexGroup(1u, kDimensionBsdfU))).xy;
  precise vec3 direction = unit(frameAround(normals.shading) * sampleCosineHemisphere(numbers));
  if (dot(direction, normals.geometric) <= 0.0) return 0.0;
  counts.shadow += 1u;
  Ray ray = rayFrom(surface, direction, false);
  if (kHasTransparency) ray.opacityKey = opacityKey(key, 1u, true);
  bool blocked = traceAny(ray, RayEnd(constants.aoDistance, kNoSlot, kNoPoint), work);
  decisions.shadow = blocked ? kShadowOccluded : kShadowVisible;
  return blocked ? 0.0 : 1.0;
}

vec3 viewOfHit(Ray ray, Hit hit, SampleKey key, inout Work work, inout RayCounts counts, inout Decisions decisions) {
  if (kView == kViewDepth) return vec3(hit.t);
  if (kView == kViewId) return indexColour(hit.index);
  Surface surface = surfaceAt(ray, hit);
  if (kHasTextures) surface.jitter = textureJitter(key, 1u);
  if (kHasChoices) chooseMaterial(surface, ray.direction, materialNumber(key, 1u));
  if (kView == kViewAlbedo) return albedo(materialAt(surface));
  if (kHasNormalMaps && kView == kViewNormal && hasTangents(surface)) {
    uint index = surface.kind >> kMaterialShift;
    uvec4 scales = sceneRow(materialTextureRow(index) + kScaleRow);
    mapNormal(surface, textureOf(index, kSlotNormal), uintBitsToFloat(scales.x), scales.z,
              -ray.direction);
  }
  Normals normals = normalsTowards(surface, -ray.direction);
  if (kView == kViewAo) return vec3(openness(surface, normals, key, work, counts, decisions));
  precise vec3 coded = 0.5 * (normals.outside ? normals.shading : -normals.shading) + 0.5;
  return coded;
}

// Returns the value of a whole sample.
vec3 viewSample(Ray ray, SampleKey key, inout Work work, inout RayCounts counts, out Decisions decisions) {
  decisions = Decisions(kRecordMiss, kLobeNone, kShadowNotTraced, true);
  uint stepsBefore = work.steps;
  if (kHasTransparency) ray.opacityKey = opacityKey(key, 1u, false);
  Hit hit = traceClosest(ray, work);
  bool missed = hit.t >= kNoHit;
  counts.vertices += missed ? 0u : 1u;
  decisions.index = missed ? kRecordMiss : hit.index;
  if (kView == kViewCost) return vec3(float(work.steps - stepsBefore));
  if (missed) return vec3(kView == kViewAo ? 1.0 : 0.0);
  return viewOfHit(ray, hit, key, work, counts, decisions);
}

#endif
