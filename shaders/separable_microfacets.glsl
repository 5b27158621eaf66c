// Microfacets that are masked for each direction on its own, with the distribution of GGX or of Beckmann:
// docs/light-transport.md sections 5.14 and 5.15. Directions are in the local frame of the shading normal.
#ifndef CANDELA_SEPARABLE_MICROFACETS_GLSL
#define CANDELA_SEPARABLE_MICROFACETS_GLSL
#include "microfacets.glsl"

// The length of the tangential part of w after its stretching by alpha.
float stretchedSine(vec3 w, vec2 alpha) { return kHasAnisotropy ? length(alpha * w.xy) : alpha.y * length(w.xy); }

// Distribution of normals such that the integral of D cosH is 1.
float separableDistribution(bool isBeckmann, vec3 h, vec2 alpha) {
  if (!isBeckmann) return ggxDistribution(h, alpha);
  float squared = h.z * h.z;
  vec2 slope = h.xy / alpha;
  float exponent = dot(slope, slope) / squared;
  return exponent > 80.0 ? 0.0 : exponential(-exponent) / (kPi * alpha.x * alpha.y * squared * squared);
}

// Smith's masking for one direction above the surface; for Beckmann, the rational function of Walter et al. (2007).
float separableMasking(bool isBeckmann, vec3 w, vec2 alpha) {
  if (!isBeckmann) return 2.0 * w.z / (w.z + stretchedLength(w, alpha));
  float slope = stretchedSine(w, alpha);
  if (w.z >= 1.6 * slope) return 1.0;
  float a = w.z / slope;
  return a * (3.535 + 2.181 * a) / (1.0 + a * (2.276 + 2.577 * a));
}

// Density of the half vectors of sampleSeparableNormal(), divided by wo.h. `d` is the distribution at h, and `masking` that of wo.
float separableNormalPdf(bool isBeckmann, float d, float masking, vec3 h, float cosO, float cosOH) {
  return isBeckmann ? d * h.z / cosOH : d * masking / cosO;
}

vec3 sampleSeparableNormal(bool isBeckmann, vec2 u, vec3 wo, vec2 alpha) {
  if (!isBeckmann) return sampleVisibleNormal(u, wo, alpha);
  vec3 disc = sampleDisc(u);
  float q = min(1.0 - disc.z, 1.0 - 1.0 / 16777216.0);
  if (q <= 0.0) return vec3(0.0, 0.0, 1.0);
  return unit(vec3(alpha * sqrt(-logOneMinus(q) / q) * disc.xy, 1.0));
}

#endif
