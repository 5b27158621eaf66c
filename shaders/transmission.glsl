// Rough glass: docs/light-transport.md section 5.5.
#ifndef CANDELA_TRANSMISSION_GLSL
#define CANDELA_TRANSMISSION_GLSL
#include "material.glsl"
#include "microfacets.glsl"

const float kMinVolumeIor = 1.01;
const float kTransmissionMargin = 1.04;  // below a film, the estimate is less than that below what glass transmits

// Interpolates one of the two glass tables: the energy that rough glass scatters once.
float glassAlbedo(float cosO, float roughness, float ior, bool outside) {
  float alpha = roughness * roughness;
  vec3 coordinates = vec3(cosO * (1.0 + alpha) / (cosO + alpha), roughness, 2.0 * (ior - 1.0) / (ior + 1.0));
  vec3 scaled = clamp(coordinates, 0.0, 1.0) * vec3(kGlassCells);
  uvec3 cell = min(uvec3(scaled), kGlassCells - 1u);
  vec3 part = scaled - vec3(cell);
  vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.yy, part.yy);
  uint layer = kGlassCells.x * kGlassCells.y;
  uint row = firstGlassRow() + cell.y * kGlassCells.x + cell.x +
             layer * (cell.z + (outside ? 0u : kGlassCells.z + 1u));
  return mix(dot(weights, sceneRowFloat(row)), dot(weights, sceneRowFloat(row + layer)), part.z);
}

// Returns glassAlbedo() of a surface that has one alpha along x and another along y.
float anisotropicGlassAlbedo(vec3 wo, float roughness, float strength, vec2 alpha, float ior, bool outside) {
  vec4 coordinates = anisotropicCoordinates(wo, roughness, strength, alpha);
  float scaled = min(sqrt(2.0 * (ior - 1.0) / (ior + 1.0)), 1.0) * float(kAnisotropicGlassIorCells);
  uint cell = min(uint(scaled), kAnisotropicGlassIorCells - 1u);
  uint layer = anisotropicRows(kAnisotropicGlassCells);
  uint row = firstAnisotropicGlassRow() + layer * (cell + (outside ? 0u : kAnisotropicGlassIorCells + 1u));
  float low = anisotropicValue(row, kAnisotropicGlassCells, coordinates);
  return min(1.0, mix(low, anisotropicValue(row + layer, kAnisotropicGlassCells, coordinates), scaled - float(cell)));
}

// The energy that glass below a film scatters once, from `albedo`, that of the same glass without a film.
vec3 albedoBelowFilm(FilmOnGlass film, float albedo, vec2 white, float ior, bool outside) {
  float transmitting = albedo;  // if it did not reflect
  if (outside) {
    float r = (ior - 1.0) / (ior + 1.0);
    float reflected = mix(white.y, white.x, r * r);
    transmitting = (albedo - reflected) / (1.0 - reflected / white.x);
  }
  transmitting = min(1.0, kTransmissionMargin * transmitting);
  return mix(vec3(albedo), mix(vec3(transmitting), vec3(white.x), film.reflectance), film.weight);
}

// `weight` of the glass among the surface's lobes; `normal` + `rise` (1 - x)^5: reflectance of the dielectric with
// its film; `white`: albedos of microfacets that reflect 1 and (1 - x)^5.
Glass glassAt(SurfaceParameters s, vec3 wo, vec3 normal, vec3 rise, FilmOnGlass film, float weight, vec2 white,
              float roughness, vec2 alpha, bool outside) {
  Glass glass;
  float ior = max(s.ior, kMinVolumeIor);
  glass.isThin = !kHasVolumes || s.isThinWalled;
  glass.eta = glass.isThin ? 1.0 : outside ? ior : 1.0 / ior;
  float albedo = white.x;
  if (!glass.isThin) {
    if (kHasAnisotropy && s.anisotropy > 0.0)
      albedo = anisotropicGlassAlbedo(wo, roughness, s.anisotropy, alpha, ior, outside);
    else
      albedo = glassAlbedo(wo.z, roughness, ior, outside);
  }
  glass.all = vec3(weight / albedo);
  if (kHasFilm && film.weight > 0.0 && !glass.isThin) {
    glass.all = weight / albedoBelowFilm(film, albedo, white, ior, outside);
  }
  glass.transmitted = glass.all * s.baseColour;
  glass.normal = normal;
  glass.grazing = rise;
  glass.absorbed = film.absorbed;
  return glass;
}

// Returns Schlick's (1 - cos)^5 with the cosine on the side of the lower index; -1: the reflection is total.
float schlickOf(Glass glass, float cosOH) {
  if (glass.eta >= 1.0) return fifthPower(1.0 - cosOH);
  float sinSquared = (1.0 - cosOH * cosOH) / (glass.eta * glass.eta);
  if (sinSquared >= 1.0) return -1.0;
  return fifthPower(1.0 - sqrt(1.0 - sinSquared));
}

vec3 glassReflectance(Glass glass, float schlick) {
  return glass.all * (schlick < 0.0 ? vec3(1.0) : glass.normal + glass.grazing * schlick);
}

// The fraction of light that is not transmitted: without a film, the largest channel of the reflectance.
vec3 keptByGlass(Glass glass, float schlick) {
  if (schlick < 0.0) return vec3(1.0);
  vec3 reflectance = glass.normal + glass.grazing * schlick;
  if (!kHasFilm) return vec3(largest(reflectance));
  return reflectance + glass.absorbed * (1.0 - schlick);
}

// The mean of the channels of keptByGlass(), with which a sampled microfacet reflects. That of equal channels is exact.
float reflectionProbability(vec3 kept) {
  if (!kHasFilm) return kept.x;
  float most = largest(kept);
  return most - dot(most - kept, vec3(1.0 / 3.0));
}

// `mirrored` is the direction that h reflects. Not for total reflection.
vec3 transmittedDirection(Glass glass, vec3 wo, vec3 h, float cosOH, vec3 mirrored) {
  if (glass.isThin) return vec3(mirrored.xy, -mirrored.z);
  float inverse = 1.0 / glass.eta;
  float cosT = sqrt(max(0.0, 1.0 - inverse * inverse * (1.0 - cosOH * cosOH)));
  return unit((inverse * cosOH - cosT) * h - inverse * wo);
}

// `pdf` is that of a surface that consists only of glass.
vec3 evaluateThinTransmission(Glass glass, vec2 alpha, vec3 wo, vec3 wi, out float pdf) {
  vec3 mirrored = vec3(wi.xy, -wi.z);
  vec3 h = unit(wo + mirrored);
  float d = ggxDistribution(h, alpha);
  float lengthO = stretchedLength(wo, alpha);
  vec3 kept = keptByGlass(glass, fifthPower(1.0 - min(dot(wo, h), 1.0)));
  pdf = (1.0 - reflectionProbability(kept)) * visibleReflectionPdf(d, wo.z, lengthO);
  return glass.transmitted * ((1.0 - kept) * d * visibility(wo, mirrored, lengthO, alpha));
}

vec3 evaluateTransmission(Glass glass, vec2 alpha, vec3 wo, vec3 wi, out float pdf) {
  if (glass.isThin) return evaluateThinTransmission(glass, alpha, wo, wi, pdf);
  pdf = 0.0;
  vec3 h = unit(wo + glass.eta * wi);
  h = h.z < 0.0 ? -h : h;
  float cosO = min(dot(wo, h), 1.0);
  float cosI = dot(wi, h);
  float schlick = schlickOf(glass, cosO);
  if (cosO <= 0.0 || cosI >= 0.0 || schlick < 0.0) return vec3(0.0);
  float sum = cosO + glass.eta * cosI;
  float jacobian = -cosI * glass.eta * glass.eta / (sum * sum);
  float d = ggxDistribution(h, alpha);
  float lengthO = stretchedLength(wo, alpha);
  vec3 kept = keptByGlass(glass, schlick);
  pdf = (1.0 - reflectionProbability(kept)) * d * 2.0 * cosO / (wo.z + lengthO) * jacobian;
  float visible = 4.0 * visibility(wo, vec3(wi.xy, -wi.z), lengthO, alpha);
  return glass.transmitted * ((1.0 - kept) * d * visible * cosO * jacobian);
}

#endif
