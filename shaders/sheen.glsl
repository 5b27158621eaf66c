// Light scattered by fibres on a surface: docs/light-transport.md section 5.9.
#ifndef CANDELA_SHEEN_GLSL
#define CANDELA_SHEEN_GLSL
#include "material.glsl"
#include "microfacets.glsl"

const float kMinSheenRoughness = 0.07;
const uvec2 kSheenCells = uvec2(kSheenCosineCells, kSheenRoughnessCells);

// Interpolates the albedo of a white sheen, times the weight in addSheen().
float weighedSheenAlbedo(float cosO, float roughness) {
  vec2 coordinates = vec2(sqrt(max(0.0, cosO * (1.0 + roughness) / (cosO + roughness))), roughness);
  vec2 scaled = clamp(coordinates, 0.0, 1.0) * vec2(kSheenCells);
  uvec2 cell = min(uvec2(scaled), kSheenCells - 1u);
  vec2 part = scaled - vec2(cell);
  vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.yy, part.yy);
  return dot(weights, sceneRowFloat(firstSheenRow() + cell.y * kSheenCells.x + cell.x));
}

float sheenCosine(float cosine) { return clamp(cosine, 0.001, 1.0); }

// Returns the fitted logarithm of the fibres' Lambda for cosines below 1/2.
float sheenFit(float x, float alpha) {
  float flatness = (1.0 - alpha) * (1.0 - alpha);
  float a = mix(21.5473, 25.3245, flatness);
  float b = mix(3.82987, 3.32435, flatness);
  float power = mix(0.19823, 0.16801, flatness);
  float slope = mix(-1.97760, -1.27393, flatness);
  float offset = mix(-4.32054, -4.85967, flatness);
  return a / (1.0 + b * exponential(power * logarithm(x))) + slope * x + offset;
}

float sheenLambda(float cosine, float alpha) {
  float c = sheenCosine(cosine);
  if (c < 0.5) return exponential(sheenFit(c, alpha));
  return exponential(2.0 * sheenFit(0.5, alpha) - sheenFit(max(1.0 - c, 1e-9), alpha));
}

// Prepares the sheen of a surface. Returns the luminance of its albedo.
float addSheen(SurfaceParameters s, vec3 wo, inout SurfaceLobes lobes) {
  float roughness = max(s.sheenRoughness, kMinSheenRoughness);
  float alpha = roughness * roughness;
  float weight = roughness / (0.198 + 0.24 * roughness);
  float bound = min(1.0, weight);  // of the albedo
  float white = bound / weight * weighedSheenAlbedo(wo.z, roughness);
  lobes.sheenAlpha = alpha;
  lobes.sheenLambda = sheenLambda(wo.z, alpha);
  lobes.sheen = s.sheenColour * (bound * (2.0 + 1.0 / alpha) / (8.0 * kPi * sheenCosine(wo.z)));
  lobes.belowSheen = 1.0 - white * largest(s.sheenColour);
  return white * luminance(s.sheenColour);
}

// Returns f of the sheen for directions above the surface.
vec3 evaluateSheen(SurfaceLobes lobes, vec3 wo, vec3 wi) {
  vec3 v = wo + wi;
  float sinSquared = clamp(dot(v.xy, v.xy) / dot(v, v), 1e-30, 1.0);
  float power = exponential(0.5 / lobes.sheenAlpha * logarithm(sinSquared));
  float masking = 1.0 / (1.0 + lobes.sheenLambda + sheenLambda(wi.z, lobes.sheenAlpha));
  return lobes.sheen * (power * masking / sheenCosine(wi.z));
}

#endif
