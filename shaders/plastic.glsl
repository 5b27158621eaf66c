// Plastic: docs/light-transport.md section 5.14. Directions are in the local frame of the shading normal.
#ifndef CANDELA_PLASTIC_GLSL
#define CANDELA_PLASTIC_GLSL
#include "fresnel.glsl"
#include "material_types.glsl"
#include "microfacets.glsl"

// Returns the fraction of the light from outside at this cosine that the boundary transmits.
float plasticTransmittance(Plastic plastic, float cosine) {
  float g;
  if (plastic.kind == kPlasticSmooth) return 1.0 - fresnelReflectance(min(cosine, 1.0), plastic.ior, g);
  float scaled = clamp(cosine, 0.0, 1.0) * float(kPlasticCells);
  uint cell = min(uint(scaled), kPlasticCells - 1u);
  uint row = cell / kPlasticCellsPerRow;
  uint inRow = cell - row * kPlasticCellsPerRow;
  vec4 nodes = sceneRowFloat(plastic.firstRow + row);
  vec2 ends = inRow == 0u ? nodes.xy : inRow == 1u ? nodes.yz : nodes.zw;
  return mix(ends.x, ends.y, scaled - float(cell));
}

// Returns the factor of the diffuse lobe for light that arrives at this cosine.
float plasticFactor(Plastic plastic, float cosine) {
  return plastic.exitFactor * plasticTransmittance(plastic, cosine);
}

// Replaces the lobes below sheen and coat by those of plastic. Returns the luminance that the boundary reflects, an estimate.
float addPlastic(SurfaceParameters s, vec3 wo, inout SurfaceLobes lobes) {
  float internal = s.plastic.y;
  lobes.plastic.kind = uint(s.plastic.x);
  lobes.plastic.ior = s.ior;
  lobes.plastic.exitFactor = 1.0 / (s.ior * s.ior * (1.0 - internal));
  lobes.plastic.firstRow = constants.firstSurfaceRow + uint(s.plastic.w);
  float entering = plasticTransmittance(lobes.plastic, wo.z);
  vec3 base = s.baseColour;
  if (s.plastic.z != 0.0) base *= (1.0 - internal) / (1.0 - internal * base);
  lobes.diffuse = entering * base;
  lobes.specular = s.specularColour;
  lobes.grazing = vec3(0.0);
  return luminance(s.specularColour) * (1.0 - entering);
}

// Distribution of normals such that the integral of D cosH is 1.
float plasticDistribution(Plastic plastic, vec3 h, float alpha) {
  if (plastic.kind != kPlasticBeckmann) return ggxDistribution(h, alpha);
  float squared = h.z * h.z;
  vec2 slope = h.xy / alpha;
  float exponent = dot(slope, slope) / squared;
  return exponent > 80.0 ? 0.0 : exponential(-exponent) / (kPi * alpha * alpha * squared * squared);
}

// Smith's masking for one direction; for Beckmann, the rational function of Walter et al. (2007).
float plasticMasking(Plastic plastic, vec3 w, float alpha) {
  if (plastic.kind != kPlasticBeckmann) return 2.0 * w.z / (w.z + stretchedLength(w, alpha));
  float slope = alpha * length(w.xy);
  if (w.z >= 1.6 * slope) return 1.0;
  float a = w.z / slope;
  return a * (3.535 + 2.181 * a) / (1.0 + a * (2.276 + 2.577 * a));
}

vec3 samplePlasticNormal(Plastic plastic, vec2 u, vec3 wo, float alpha) {
  if (plastic.kind != kPlasticBeckmann) return sampleVisibleNormal(u, wo, vec2(alpha));
  vec3 disc = sampleDisc(u);
  float q = min(1.0 - disc.z, 1.0 - 1.0 / 16777216.0);
  if (q <= 0.0) return vec3(0.0, 0.0, 1.0);
  return unit(vec3(alpha * sqrt(-logOneMinus(q) / q) * disc.xy, 1.0));
}

// Returns f and the pdf of plastic without sheen and coat, for wi.z > 0.
vec3 evaluatePlastic(SurfaceLobes lobes, vec3 wo, vec3 wi, out float pdf) {
  float alpha = lobes.alpha.y;
  vec3 h = unit(wo + wi);
  float cosOH = min(dot(wo, h), 1.0);
  float d = plasticDistribution(lobes.plastic, h, alpha);
  float maskingO = plasticMasking(lobes.plastic, wo, alpha);
  bool isVisible = lobes.plastic.kind != kPlasticBeckmann;
  float normalPdf = isVisible ? d * maskingO / wo.z : d * h.z / cosOH;  // divided by wo.h
  pdf = lobes.diffuseProbability * (wi.z / kPi) + 0.25 * lobes.specularProbability * normalPdf;
  float g;
  float reflectance = fresnelReflectance(cosOH, lobes.plastic.ior, g);
  float shape = d * maskingO * plasticMasking(lobes.plastic, wi, alpha) / (4.0 * wo.z * wi.z);
  return lobes.diffuse * (plasticFactor(lobes.plastic, wi.z) / kPi) + lobes.specular * (reflectance * shape);
}

#endif
