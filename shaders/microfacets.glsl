// GGX microfacets with height-correlated masking and shadowing: docs/light-transport.md sections 5.2, 5.3
// and 5.12.
#ifndef CANDELA_MICROFACETS_GLSL
#define CANDELA_MICROFACETS_GLSL
#include "sampling.glsl"
#include "scene_access.glsl"

const float kMinRoughness = 0.01;
const uvec3 kGlassCells = uvec3(kGlassCosineCells, kGlassRoughnessCells, kGlassIorCells);
const uint kGlassTableRows = 2u * kGlassCosineCells * kGlassRoughnessCells * (kGlassIorCells + 1u);
const uvec4 kAnisotropicCells = uvec4(kAnisotropicCosineCells, kAnisotropicAzimuthCells, kAnisotropicRoughnessCells,
                                      kAnisotropicStrengthCells);
const uvec4 kAnisotropicGlassCells = uvec4(kAnisotropicGlassCosineCells, kAnisotropicGlassAzimuthCells,
                                           kAnisotropicGlassRoughnessCells, kAnisotropicGlassStrengthCells);

// The first records of the tables after the energy tables, which exist only if the scene needs them.
uint firstGlassRow() { return constants.firstEnergyRow + kEnergyRows * kEnergyCells * kEnergyCells; }
uint firstSheenRow() { return firstGlassRow() + (kHasVolumes ? kGlassTableRows : 0u); }
uint firstAnisotropicRow() { return firstSheenRow() + (kHasSheen ? kSheenCosineCells * kSheenRoughnessCells : 0u); }

// The number of records of a table with these cells of cosines, azimuths, roughnesses and strengths.
uint anisotropicRows(uvec4 cells) { return cells.x * cells.y * (cells.z + 1u) * (cells.w + 1u); }
uint firstAnisotropicGlassRow() { return firstAnisotropicRow() + 2u * anisotropicRows(kAnisotropicCells); }

// The length of w after its stretching by alpha.
float stretchedLength(vec3 w, float alpha) { return sqrt(alpha * alpha * dot(w.xy, w.xy) + w.z * w.z); }

// Two alphas are those along the x and the y axis. Without anisotropy, they are equal.
float stretchedLength(vec3 w, vec2 alpha) {
  if (!kHasAnisotropy) return stretchedLength(w, alpha.y);
  return length(vec3(alpha * w.xy, w.z));
}

float ggxDistribution(vec3 h, float alpha) {
  float inverse = 1.0 / alpha;
  vec2 slope = h.xy * inverse;
  float q = dot(slope, slope) + h.z * h.z;
  return inverse * inverse / (kPi * q * q);
}

float ggxDistribution(vec3 h, vec2 alpha) {
  if (!kHasAnisotropy) return ggxDistribution(h, alpha.y);
  vec2 slope = h.xy / alpha;
  float q = dot(slope, slope) + h.z * h.z;
  return 1.0 / (kPi * alpha.x * alpha.y * q * q);
}

// Samples a normal that is visible from wo by a spherical cap (Dupuy and Benyoub 2023).
vec3 sampleVisibleNormal(vec2 u, vec3 wo, vec2 alpha) {
  vec3 stretched = unit(vec3(alpha * wo.xy, wo.z));
  vec3 h = sampleCap(u, 1.0 + stretched.z) + stretched;
  return unit(vec3(alpha * h.xy, h.z));
}

// Density of the direction that a visible normal reflects.
float visibleReflectionPdf(float d, float cosO, float lengthO) { return d / (2.0 * (cosO + lengthO)); }

// Returns G2 / (4 cosO cosI).
float visibility(vec3 wo, vec3 wi, float lengthO, vec2 alpha) {
  return 0.5 / (wi.z * lengthO + wo.z * stretchedLength(wi, alpha));
}

float fifthPower(float x) {
  float x2 = x * x;
  return x2 * x2 * x;
}

// Directional albedos of single scattering: x with a reflectance of 1, y with (1 - wo.h)^5.
vec2 microfacetAlbedo(float cosO, float roughness) {
  float alpha = roughness * roughness;
  vec2 coordinates = vec2(cosO * (1.0 + alpha) / (cosO + alpha), roughness);
  vec2 scaled = clamp(coordinates, 0.0, 1.0) * float(kEnergyCells);
  uvec2 cell = min(uvec2(scaled), kEnergyCells - 1u);
  vec2 part = scaled - vec2(cell);
  vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.yy, part.yy);
  uint row = constants.firstEnergyRow + kEnergyRows * (cell.y * kEnergyCells + cell.x);
  float white = dot(weights, sceneRowFloat(row));
  float tilt = dot(weights, sceneRowFloat(row + 1u));
  return vec2(white, white * fifthPower(max(0.0, 1.0 - cosO - alpha * tilt)));
}

// Interpolates a table of anisotropic microfacets that begins at `first`. The coordinates are fractions of the cosine,
// azimuth, roughness and strength.
float anisotropicValue(uint first, uvec4 cells, vec4 coordinates) {
  vec4 scaled = clamp(coordinates, 0.0, 1.0) * vec4(cells);
  uvec4 cell = min(uvec4(scaled), cells - 1u);
  vec4 part = scaled - vec4(cell);
  vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.yy, part.yy);
  uint plane = cells.x * cells.y;
  uint strength = plane * (cells.z + 1u);
  uint row = first + cell.w * strength + cell.z * plane + cell.y * cells.x + cell.x;
  vec2 low = vec2(dot(weights, sceneRowFloat(row)), dot(weights, sceneRowFloat(row + plane)));
  vec2 high = vec2(dot(weights, sceneRowFloat(row + strength)), dot(weights, sceneRowFloat(row + strength + plane)));
  vec2 across = mix(low, high, part.w);
  return mix(across.x, across.y, part.z);
}

// Returns fractions of the cosine, azimuth, roughness and strength for anisotropicValue().
vec4 anisotropicCoordinates(vec3 wo, float roughness, float strength, vec2 alpha) {
  float square = dot(wo.xy, wo.xy);
  float cosSquared = square > 0.0 ? wo.x * wo.x / square : 1.0;
  float towards = sqrt(mix(alpha.y * alpha.y, alpha.x * alpha.x, cosSquared));
  float azimuth = sqrt(cosSquared * (alpha.x + alpha.y) / (towards + alpha.y));
  return vec4(wo.z * (1.0 + towards) / (wo.z + towards), azimuth, roughness, strength);
}

// Returns microfacetAlbedo() of a surface that has one alpha along x and another along y.
vec2 anisotropicAlbedo(vec3 wo, float roughness, float strength, vec2 alpha) {
  vec4 coordinates = anisotropicCoordinates(wo, roughness, strength, alpha);
  float white = min(1.0, anisotropicValue(firstAnisotropicRow(), kAnisotropicCells, coordinates));
  coordinates.x = wo.z * (1.0 + alpha.x) / (wo.z + alpha.x);
  uint tilts = firstAnisotropicRow() + anisotropicRows(kAnisotropicCells);
  float tilt = anisotropicValue(tilts, kAnisotropicCells, coordinates);
  return vec2(white, white * fifthPower(clamp(1.0 - wo.z - alpha.x * tilt, 0.0, 1.0)));
}

#endif
