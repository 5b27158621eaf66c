// The film's exact sums: samples become integers in units of 2^-40 and are added with carry.
#ifndef CANDELA_FILM_GLSL
#define CANDELA_FILM_GLSL
#include "math.glsl"
#include "options.glsl"
#include "shared/render_data.h"

const float kFilmMaximum = 1048576.0;

// Returns floor(value 2^40) as 96 bits, least significant word first, for a value in [0, 2^40]. Every step is exact,
// because it only removes leading bits.
uvec3 toFixed(float value) {
  precise float high = floor(value * (1.0 / 16777216.0));
  precise float rest = (value - high * 16777216.0) * 256.0;
  precise float middle = floor(rest);
  precise float low = (rest - middle) * 4294967296.0;
  return uvec3(uint(low), uint(middle), uint(high));
}

uvec3 addFixed(uvec3 sum, uvec3 term) {
  uint carry0, carry1, carry2;
  uint low = uaddCarry(sum.x, term.x, carry0);
  uint middle = uaddCarry(sum.y, term.y, carry1);
  uint middleCarried = uaddCarry(middle, carry0, carry2);
  return uvec3(low, middleCarried, sum.z + term.z + carry1 + carry2);
}

// Returns false for NaN, infinities and negative numbers. It inspects the bits, because comparisons with NaN are not
// relied on.
bool inRange(float value) { return floatBitsToUint(value) < 0x7f800000u || value == 0.0; }

float keptValue(float value) { return inRange(value) ? min(value, kFilmMaximum) : 0.0; }

// Returns radiance in the unit of the film's sums. The product with a power of two is exact; what is below the normal
// range of binary32 is below the resolution of the sums.
vec3 filmRadiance(vec3 radiance) {
  if (kFilmScale == 0u) return radiance;
  precise vec3 scaled = radiance * uintBitsToFloat((127u - kFilmScale) << 23);
  return scaled;
}

// Returns the value that the film adds for a sample of this radiance in its unit.
vec3 keptRadiance(vec3 scaled) { return vec3(keptValue(scaled.x), keptValue(scaled.y), keptValue(scaled.z)); }

void addSample(inout FilmRows film, vec3 radiance, uint sampleIndex) {
  vec3 scaled = filmRadiance(radiance);
  bool usable = inRange(scaled.x) && inRange(scaled.y) && inRange(scaled.z);
  vec3 clamped = keptRadiance(scaled);
  bool bad = !usable || clamped != scaled;
  precise float y = luminance(clamped);
  precise float ySquared = y * y;
  film.red = uvec4(addFixed(film.red.xyz, toFixed(clamped.x)), film.red.w + 1u);
  film.green = uvec4(addFixed(film.green.xyz, toFixed(clamped.y)), film.green.w + (bad ? 1u : 0u));
  bool first = bad && (film.blue.w == 0u || sampleIndex + 1u < film.blue.w);
  film.blue = uvec4(addFixed(film.blue.xyz, toFixed(clamped.z)), first ? sampleIndex + 1u : film.blue.w);
  film.luminanceSquared.xyz = addFixed(film.luminanceSquared.xyz, toFixed(ySquared));
}

// Counts a sample whose camera ray hit something.
void addHit(inout FilmRows film) { film.luminanceSquared.w += 1u; }

#endif
