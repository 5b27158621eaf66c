// The key of random numbers, and the hash that makes them.
#ifndef CANDELA_SAMPLE_KEY_GLSL
#define CANDELA_SAMPLE_KEY_GLSL
#include "options.glsl"
#include "shared/dimensions.h"

// The part of the key of a random number that is common to all dimensions of one sample of a pixel.
struct SampleKey {
  uint pixel;   // x + 65536 y
  uint sampleIndex;
  uint seed;
  uint strata;  // n of the n x n strata; 0: none
};

const uint kScrambleSeed = 0x5f356495u;
const uint kGroupSize = 4u;

float toUnit(uint word) { return float(word >> 8) * (1.0 / 16777216.0); }
vec2 toUnit(uvec2 words) { return vec2(words >> 8) * (1.0 / 16777216.0); }
vec4 toUnit(uvec4 words) { return vec4(words >> 8) * (1.0 / 16777216.0); }

// The hash pcg4d of Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 2020.
uvec4 pcg4d(uvec4 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  v ^= v >> 16;
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  return v;
}

#endif
