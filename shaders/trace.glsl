// Notes that record what a path computes, for the kernel that replays one sample. In all other kernels, notes
// generate no code: docs/driver-workarounds.md section 10.
#ifndef CANDELA_TRACE_GLSL
#define CANDELA_TRACE_GLSL

#ifdef CANDELA_TRACES_PATHS
#include "bsdf.glsl"
#include "lights.glsl"
#include "normals.glsl"
#include "shared/trace_rows.h"

// The current vertex.
TracedVertex traced;

void noteStage(uint stage) { traced.throughputStages.w |= stage; }

void noteSurface(Ray ray, Surface surface, float t) {
  Normals normals = normalsTowards(surface, -ray.direction);
  noteStage(kTracedHit | (normals.outside ? kTracedOutside : 0u));
  traced.originDistance.w = t;
  traced.positionPrimitive = uvec4(floatBitsToUint(surface.position), surface.index);
  traced.normalMaterial = uvec4(floatBitsToUint(normals.geometric), surface.kind >> kMaterialShift);
  traced.shadingNormalLobe = uvec4(floatBitsToUint(normals.shading), kLobeNone);
}

void noteEmission(vec3 emission, float weight) {
  if (largest(emission) <= 0.0) return;
  noteStage(kTracedEmission);
  traced.emissionWeight = vec4(emission * weight, weight);
}

void noteLightChoice(uint entry, Light light) {
  noteStage(kTracedLight);
  uint primitive = light.slot != kNoSlot ? indexOf(rowsOfSlot(light.slot)) : kRecordMiss;
  traced.lightEntry = uvec4(entry, primitive, kShadowNotTraced, 0u);
}

void noteShadowRay(LightSample lit, float bsdfPdf, float weight, vec3 radiance) {
  traced.lightDirectionDistance = vec4(lit.wi, lit.distance);
  traced.lightDensities = vec4(lit.pdf, bsdfPdf, weight, 0.0);
  traced.lightRadiance = vec4(radiance, 0.0);
}

void noteShadow(uint shadow) {
  traced.lightEntry.z = shadow;
  if (shadow == kShadowVisible) return;
  traced.lightDensities.z = 0.0;
  traced.lightRadiance = vec4(0.0);
}

void noteScattering(BsdfSample next, vec3 direction) {
  traced.shadingNormalLobe.w = next.lobe;
  traced.nextDirectionPdf = vec4(direction, next.pdf);
  traced.weightSurvival = vec4(next.weight, 1.0);
}

void noteRoulette(float survival) {
  noteStage(kTracedRoulette);
  traced.weightSurvival.w = survival;
}

#else
#define noteSurface(ray, surface, t)
#define noteEmission(emission, weight)
#define noteLightChoice(entry, light)
#define noteShadowRay(lit, bsdfPdf, weight, radiance)
#define noteShadow(shadow)
#define noteScattering(next, direction)
#define noteRoulette(survival)
#endif

#endif
