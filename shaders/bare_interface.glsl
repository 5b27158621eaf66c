// A single interface between two media: docs/light-transport.md section 5.15. Directions are in the local frame of the
// shading normal.
#ifndef CANDELA_BARE_INTERFACE_GLSL
#define CANDELA_BARE_INTERFACE_GLSL
#include "bsdf_sample.glsl"
#include "conductor.glsl"
#include "fresnel.glsl"
#include "material.glsl"
#include "separable_microfacets.glsl"

bool isThinInterface(SurfaceParameters s) { return !kHasVolumes || s.isThinWalled; }

// The lobes of a bare interface: their directions are those of this file, and the others have no light.
SurfaceLobes interfaceLobes(SurfaceParameters s) {
  SurfaceLobes lobes;
  float roughness = max(s.roughness, kMinRoughness);
  lobes.alpha = vec2(roughness * roughness);
  if (kHasAnisotropy && s.anisotropy > 0.0) lobes.alpha.x = mix(lobes.alpha.y, 1.0, s.anisotropy * s.anisotropy);
  lobes.diffuse = vec3(0.0);
  lobes.diffuseProbability = 0.0;
  lobes.coatProbability = 0.0;
  lobes.sheenProbability = 0.0;
  lobes.plastic.kind = kPlasticNone;
  return lobes;
}

// Index of refraction beyond the interface relative to the side of wo.
float interfaceEta(SurfaceParameters s, bool outside) { return outside || isThinInterface(s) ? s.ior : 1.0 / s.ior; }

vec3 metalReflectance(SurfaceParameters s, float cosine) {
  if (kHasConductors && s.isConductor) return s.baseColour * conductorReflectance(cosine, s.eta, s.kappa);
  return s.baseColour;
}

BsdfSample sampleSmoothInterface(SurfaceParameters s, vec3 wo, bool outside, float number) {
  vec3 mirrored = vec3(-wo.xy, wo.z);
  if (!kHasTransmission || s.transmissionWeight <= 0.0) {
    return BsdfSample(mirrored, metalReflectance(s, wo.z), 0.0, kLobeMirror);
  }
  float eta = interfaceEta(s, outside);
  float g;
  precise float reflectance = fresnelReflectance(min(wo.z, 1.0), eta, g);
  if (isThinInterface(s)) reflectance = 2.0 * reflectance / (1.0 + reflectance);
  if (number < reflectance) return BsdfSample(mirrored, s.specularColour, 0.0, kLobeReflect);
  vec3 wi = isThinInterface(s) ? -wo : vec3(-wo.xy, -g) / eta;
  return BsdfSample(wi, s.baseColour, 0.0, kLobeRefract);
}

// Returns f and the pdf of a rough interface; 0 for a smooth one.
vec3 evaluateInterface(SurfaceParameters s, vec2 alpha, bool outside, vec3 wo, vec3 wi, out float pdf) {
  pdf = 0.0;
  bool transmitted = wi.z < 0.0;
  bool transmits = kHasTransmission && s.transmissionWeight > 0.0;
  if (isSmoothInterface(s) || wo.z <= 0.0 || wi.z == 0.0 || transmitted && !transmits) return vec3(0.0);
  float eta = interfaceEta(s, outside);
  vec3 h = unit(transmitted ? wo + eta * wi : wo + wi);
  h = h.z < 0.0 ? -h : h;
  float cosO = min(dot(wo, h), 1.0);
  float cosI = dot(wi, h);
  if (cosO <= 0.0 || transmitted && cosI >= 0.0) return vec3(0.0);
  bool isBeckmann = s.plastic.x == float(kInterfaceBeckmann);
  float d = separableDistribution(isBeckmann, h, alpha);
  float maskingO = separableMasking(isBeckmann, wo, alpha);
  float jacobian = 0.25;  // of half vectors for directions, times wo.h
  if (transmitted) {
    float sum = cosO + eta * cosI;
    jacobian = -cosI * cosO * eta * eta / (sum * sum);
  }
  float cosWi = abs(wi.z);
  float shape = jacobian * d * maskingO * separableMasking(isBeckmann, vec3(wi.xy, cosWi), alpha) / (wo.z * cosWi);
  pdf = jacobian * separableNormalPdf(isBeckmann, d, maskingO, h, wo.z, cosO);
  if (!transmits) return metalReflectance(s, cosO) * shape;
  float g;
  float reflectance = fresnelReflectance(cosO, eta, g);
  float fraction = transmitted ? 1.0 - reflectance : reflectance;
  pdf *= fraction;
  return (transmitted ? s.baseColour : s.specularColour) * (fraction * shape);
}

// Samples a rough interface. numbers.x chooses between reflection and transmission, numbers.yz the normal.
BsdfSample sampleRoughInterface(SurfaceParameters s, vec2 alpha, bool outside, vec3 wo, vec3 numbers) {
  bool isBeckmann = s.plastic.x == float(kInterfaceBeckmann);
  vec3 h = sampleSeparableNormal(isBeckmann, numbers.yz, wo, alpha);
  float cosOH = min(dot(wo, h), 1.0);
  BsdfSample result = kAbsorbed;
  result.wi = 2.0 * cosOH * h - wo;
  bool transmitted = false;
  if (kHasTransmission && s.transmissionWeight > 0.0 && cosOH > 0.0) {
    float eta = interfaceEta(s, outside);
    float g;
    precise float reflectance = fresnelReflectance(cosOH, eta, g);
    transmitted = numbers.x >= reflectance;
    if (transmitted) result.wi = unit(((cosOH - g) * h - wo) / eta);
  }
  if ((result.wi.z < 0.0) != transmitted) return kAbsorbed;
  vec3 f = evaluateInterface(s, alpha, outside, wo, result.wi, result.pdf);
  if (result.pdf <= 0.0) return kAbsorbed;
  result.weight = f * (abs(result.wi.z) / result.pdf);
  result.lobe = transmitted ? kLobeRefract : kLobeGlossy;
  return result;
}

BsdfSample sampleInterface(SurfaceParameters s, vec2 alpha, bool outside, vec3 wo, vec3 numbers) {
  if (isSmoothInterface(s)) return sampleSmoothInterface(s, wo, outside, numbers.x);
  return sampleRoughInterface(s, alpha, outside, wo, numbers);
}

#endif
