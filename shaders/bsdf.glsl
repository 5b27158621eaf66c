// Materials as weighted lobes: docs/light-transport.md section 5. Directions are in the local frame of the shading
// normal, with z along the normal; wo and wi point away from the surface.
#ifndef CANDELA_BSDF_GLSL
#define CANDELA_BSDF_GLSL
#include "bsdf_sample.glsl"
#include "material.glsl"
#include "options.glsl"
#include "sampling.glsl"
#include "shared/render_data.h"
#include "surface.glsl"

float weightSum(Material m) { return m.diffuseWeight + m.glossyWeight + m.dielectricWeight; }

// Returns whether some lobe with a density scatters to this side of the surface. Light sampling can only contribute
// there.
bool scattersTo(Material m, bool transmitted) {
  if (kHasSurfaces && m.isSurface && isSmoothInterface(m.surface)) return false;
  if (kHasSurfaces && m.isSurface) return !transmitted || (kHasTransmission && m.surface.transmissionWeight > 0.0);
  return !transmitted && !m.mirror && m.diffuseWeight + m.glossyWeight > 0.0;
}

bool hasSmoothLobe(Material m) { return scattersTo(m, false) || scattersTo(m, true); }

// Blinn's distribution, normalised so that the integral of D cosH is 1. It is computed from the sine, which keeps its
// relative accuracy at the lobe's peak: cosH^n = exp(n/2 log(1 - sinH^2)).
float blinnDistribution(vec3 h, float exponent) {
  float sinSquared = min(h.x * h.x + h.y * h.y, 1.0 - 1.0 / 16777216.0);
  float power = 1.0 + expMinusOne(0.5 * exponent * logOneMinus(sinSquared));
  return (exponent + 2.0) / (2.0 * kPi) * power;
}

// Shadowing and masking by Torrance and Sparrow's V-grooves.
float grooves(float cosH, float cosO, float cosI, float cosOH) {
  return min(1.0, 2.0 * cosH * min(cosO, cosI) / cosOH);
}

// Samples a half vector with pdf D cosH.
vec3 sampleBlinn(vec2 u, float exponent) {
  vec2 disc = sampleDisc(u).xy;
  float q = min(dot(disc, disc), 1.0 - 1.0 / 16777216.0);
  if (q == 0.0) return vec3(0.0, 0.0, 1.0);
  float sinSquared = -expMinusOne(2.0 / (exponent + 2.0) * logOneMinus(q));
  return vec3(disc * sqrt(sinSquared / q), sqrt(max(0.0, 1.0 - sinSquared)));
}

void addDiffuse(Material m, vec3 wo, vec3 wi, inout vec3 f, inout float pdf) {
  if (wi.z <= 0.0 || wo.z <= 0.0) return;
  f += m.diffuse * (m.diffuseWeight / kPi);
  pdf += m.diffuseWeight / weightSum(m) * (wi.z / kPi);
}

void addGlossy(Material m, vec3 wo, vec3 wi, inout vec3 f, inout float pdf) {
  if (wi.z <= 0.0 || wo.z <= 0.0) return;
  vec3 h = unit(wo + wi);
  float cosOH = dot(wo, h);
  float d = blinnDistribution(h, m.exponent);
  f += m.glossy * (m.glossyWeight * d * grooves(h.z, wo.z, wi.z, cosOH) / (4.0 * wo.z * wi.z));
  pdf += m.glossyWeight / weightSum(m) * d * h.z / (4.0 * cosOH);
}

// Returns the sum of f over all lobes with a density, and the pdf with which sampleBsdf chooses wi, which may be any
// direction of the sphere. Each lobe adds to both on the side of the surface to which it scatters. The integrator
// multiplies f by |wi.z|.
vec3 evaluateBsdf(Material m, vec3 wo, vec3 wi, out float pdf) {
  if (kHasSurfaces && m.isSurface) return evaluateSurfaceMaterial(m, wo, wi, pdf);
  vec3 f = vec3(0.0);
  pdf = 0.0;
  addDiffuse(m, wo, wi, f, pdf);
  if (kHasGlossy && m.glossyWeight > 0.0) addGlossy(m, wo, wi, f, pdf);
  return f;
}

// Computes the members that depend on wo. Must be called before a material is evaluated or sampled. `outside`: wo is on the side to
// which the primitive's own normal points.
void prepareLobes(inout Material m, vec3 wo, bool outside) {
  if (!kHasSurfaces || !m.isSurface) return;
  m.outside = outside;
  if (isBareInterface(m.surface)) {
    m.lobes = interfaceLobes(m.surface);
    return;
  }
  bool disperses = kHasDispersion && m.surface.transmissionDispersionScale > 0.0;
  m.lobes = lobesAt(disperses ? inChannel(m.surface, m.channel) : m.surface, wo, outside);
}

BsdfSample sampleSmoothLobes(Material m, vec3 wo, bool diffuseLobe, vec2 u) {
  BsdfSample result = kAbsorbed;
  if (diffuseLobe) {
    result.wi = sampleCosineHemisphere(u);
    if (!kHasMixtures || m.diffuseWeight == weightSum(m)) {  // the pdf cancels
      result.weight = m.diffuse * m.diffuseWeight;
      result.pdf = result.wi.z / kPi;
      result.lobe = result.wi.z > 0.0 ? kLobeDiffuse : kLobeNone;
      return result;
    }
  } else {
    vec3 h = sampleBlinn(u, m.exponent);
    result.wi = 2.0 * dot(wo, h) * h - wo;
  }
  vec3 f = evaluateBsdf(m, wo, result.wi, result.pdf);
  if (result.pdf <= 0.0) return kAbsorbed;
  result.weight = f * (abs(result.wi.z) / result.pdf);
  result.lobe = diffuseLobe ? kLobeDiffuse : kLobeGlossy;
  return result;
}

// Samples reflection or refraction. `outside`: wo is on the side to which the primitive's own normal points.
BsdfSample sampleDielectric(Material m, vec3 wo, bool outside, float u) {
  BsdfSample result = kAbsorbed;
  result.weight = m.specular * weightSum(m);
  float eta = outside ? 1.0 / m.ior : m.ior;
  precise float sinSquaredT = eta * eta * (1.0 - wo.z * wo.z);
  float cosT = sqrt(max(0.0, 1.0 - sinSquaredT));
  float r = (m.ior - 1.0) / (m.ior + 1.0);
  float r0 = r * r;
  float grazing = 1.0 - (outside ? wo.z : cosT);
  float grazing2 = grazing * grazing;
  precise float reflectance = r0 + (1.0 - r0) * (grazing2 * grazing2 * grazing);
  bool reflected = sinSquaredT >= 1.0 || u < reflectance;
  result.wi = reflected ? vec3(-wo.xy, wo.z) : vec3(-eta * wo.xy, -cosT);
  result.lobe = reflected ? kLobeReflect : kLobeRefract;
  return result;
}

// Samples a direction. numbers.x chooses the lobe, numbers.yz the direction.
BsdfSample sampleBsdf(Material m, vec3 wo, bool outside, vec3 numbers) {
  if (kHasSurfaces && m.isSurface) return sampleSurfaceMaterial(m, wo, numbers);
  if (kHasMirror && m.mirror) return BsdfSample(vec3(-wo.xy, wo.z), m.specular, 0.0, kLobeMirror);
  float total = weightSum(m);
  if (total <= 0.0) return kAbsorbed;
  precise float diffuseProbability = m.diffuseWeight / total;
  precise float smoothProbability = diffuseProbability + m.glossyWeight / total;
  bool dielectric = m.dielectricWeight > 0.0 && numbers.x >= smoothProbability;
  if (kHasDielectric && dielectric) return sampleDielectric(m, wo, outside, numbers.y);
  if (kHasDiffuse || kHasGlossy) {
    bool diffuseLobe = !kHasGlossy || (kHasDiffuse && numbers.x < diffuseProbability);
    return sampleSmoothLobes(m, wo, diffuseLobe, numbers.yz);
  }
  return kAbsorbed;
}

#endif
