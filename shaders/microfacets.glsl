// GGX microfacets with height-correlated masking and shadowing: docs/light-transport.md sections 5.2 and 5.3.
#ifndef CANDELA_MICROFACETS_GLSL
#define CANDELA_MICROFACETS_GLSL
#include "sampling.glsl"
#include "scene_access.glsl"

const float kMinRoughness = 0.01;
const uvec3 kGlassCells = uvec3(kGlassCosineCells, kGlassRoughnessCells, kGlassIorCells);

// The length of w after its stretching by alpha.
float stretchedLength(vec3 w, float alpha) { return sqrt(alpha * alpha * dot(w.xy, w.xy) + w.z * w.z); }

float ggxDistribution(vec3 h, float alpha) {
  float inverse = 1.0 / alpha;
  vec2 slope = h.xy * inverse;
  float q = dot(slope, slope) + h.z * h.z;
  return inverse * inverse / (kPi * q * q);
}

// Samples a normal that is visible from wo by a spherical cap (Dupuy and Benyoub 2023).
vec3 sampleVisibleNormal(vec2 u, vec3 wo, float alpha) {
  vec3 stretched = unit(vec3(alpha * wo.xy, wo.z));
  vec3 h = sampleCap(u, 1.0 + stretched.z) + stretched;
  return unit(vec3(alpha * h.xy, h.z));
}

// Density of the direction that a visible normal reflects.
float visibleReflectionPdf(float d, float cosO, float lengthO) { return d / (2.0 * (cosO + lengthO)); }

// Returns G2 / (4 cosO cosI).
float visibility(vec3 wo, vec3 wi, float lengthO, float alpha) {
  return 0.5 / (wi.z * lengthO + wo.z * stretchedLength(wi, alpha));
}

float fifthPower(float x) {
  float x2 = x * x;
  return x2 * x2 * x;
}

// Directional albedos of single scattering: x with a reflectance of 1, y with (1 - wo.h)^5.
vec2 microfacetAlbedo(float cosO, float roughness) {
  float alpha = roughness * roughness;
  vec2 place = vec2(cosO * (1.0 + alpha) / (cosO + alpha), roughness);
  vec2 scaled = clamp(place, 0.0, 1.0) * float(kEnergyCells);
  uvec2 cell = min(uvec2(scaled), kEnergyCells - 1u);
  vec2 part = scaled - vec2(cell);
  vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.yy, part.yy);
  uint row = constants.firstEnergyRow + kEnergyRows * (cell.y * kEnergyCells + cell.x);
  float white = dot(weights, sceneRowFloat(row));
  float tilt = dot(weights, sceneRowFloat(row + 1u));
  return vec2(white, white * fifthPower(max(0.0, 1.0 - cosO - alpha * tilt)));
}

#endif
