// Reflection at films as thin as the wavelengths of light: docs/light-transport.md section 5.11.
#ifndef CANDELA_THIN_FILM_GLSL
#define CANDELA_THIN_FILM_GLSL
#include "material.glsl"
#include "math.glsl"
#include "microfacets.glsl"

// Returns one Gaussian of a colour matching function, scaled by v sqrt(2 pi s) / 1.0685e-7. `frequency` is per nanometre,
// as `difference` is in nanometres, and `decay` is 4 pi^2 s.
float interferenceTerm(float difference, float turns, float scale, float frequency, float decay) {
  return scale * cosSinOfTurns(difference * frequency + turns).x * exponential(-decay * difference * difference);
}

// Returns the response of each channel to a path difference. `turns` are the phase shifts divided by 2 pi.
vec3 interference(float difference, vec3 turns) {
  float x = interferenceTerm(difference, turns.x, 0.84659000, 1.6810e-3, 1.70854696e-7) +
            interferenceTerm(difference, turns.x, 0.15386831, 2.2399e-3, 1.78766171e-7);
  float y = interferenceTerm(difference, turns.y, 1.00022189, 1.7953e-3, 3.67330884e-7);
  float z = interferenceTerm(difference, turns.z, 1.00112249, 2.2084e-3, 2.61035245e-7);
  return vec3(3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
              0.0556434 * x - 0.2040259 * y + 1.0572252 * z);
}

float schlickRise(float normal, float cosine) { return normal + (1.0 - normal) * fifthPower(1.0 - cosine); }

// Returns the reflectance of the film on a base that reflects `base` at normal incidence.
vec3 filmReflectance(SurfaceParameters s, float cosine, vec3 base) {
  float blend = clamp(s.filmThickness / 0.03, 0.0, 1.0);
  float e = mix(1.0, s.filmIor, blend * blend * (3.0 - 2.0 * blend));
  float refracted = sqrt(max(0.0, 1.0 - (1.0 - cosine * cosine) / (e * e)));
  float r = (e - 1.0) / (e + 1.0);
  float r12 = schlickRise(r * r, cosine);
  float t12 = 1.0 - r12;
  vec3 root = sqrt(min(base + 0.0001, 0.9999));
  vec3 behind = (1.0 + root) / (1.0 - root);
  vec3 r23 = (behind - e) / (behind + e);
  r23 *= r23;
  r23 += (1.0 - r23) * fifthPower(1.0 - refracted);
  vec3 turns = mix(vec3(0.5), vec3(1.0), lessThan(behind, vec3(e)));
  vec3 r123 = clamp(r12 * r23, 1e-5, 0.9999);
  vec3 sum = t12 * t12 * r23 / (1.0 - r123);
  float difference = 2.0 * e * s.filmThickness * refracted;
  vec3 waves = sqrt(r123) * interference(difference, turns) + r123 * interference(2.0 * difference, 2.0 * turns);
  return clamp(r12 + sum + 2.0 * (sum - t12) * waves, 0.0, 1.0);
}

// Returns the cosine of a direction outside of the film.
float filmCosine(SurfaceParameters s, float cosO, bool outside) {
  if (!kHasVolumes || s.isThinWalled || outside) return min(cosO, 1.0);
  return sqrt(max(0.0, 1.0 - s.ior * s.ior * (1.0 - cosO * cosO)));
}

// Adds the film to a base with the reflectance `weight` (`normal` + `rise` (1 - x)^5). The weight becomes 1. `covered` is
// the film's reflectance. Returns that by which multiple scattering is compensated, which was `normal` without the film.
vec3 addFilm(SurfaceParameters s, float cosine, inout float weight, inout vec3 normal, inout vec3 rise,
             out vec3 covered) {
  covered = filmReflectance(s, cosine, weight * normal);
  vec3 compensated = mix(normal, covered, s.filmWeight);
  normal = mix(weight * normal, covered, s.filmWeight);
  rise *= weight * (1.0 - s.filmWeight);
  weight = 1.0;
  return compensated;
}

#endif
