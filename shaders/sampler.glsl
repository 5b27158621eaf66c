// Random numbers as a pure function of (seed, pixel, sample, dimension): docs/light-transport.md section 1.
#ifndef CANDELA_SAMPLER_GLSL
#define CANDELA_SAMPLER_GLSL
#include "options.glsl"
#include "shared/dimensions.h"
#include "sobol_points.glsl"

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

// Laine and Karras' permutation with Burley's constants (JCGT 2020). On reversed bits it is an Owen scramble.
uvec4 owenPermute(uvec4 x, uvec4 key) {
  x += key;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

// Returns four dimensions of the scrambled Sobol sequence. The first one is the van der Corput sequence, whose reversed
// bits are the index itself.
uvec4 sobolGroup(SampleKey key, uint group) {
  uvec4 seeds = pcg4d(uvec4(key.pixel, 0u, group, key.seed ^ kScrambleSeed));
  uint shuffle = seeds.x ^ seeds.y ^ seeds.z ^ seeds.w;
  uint reversedIndex = owenPermute(uvec4(bitfieldReverse(key.sampleIndex)), uvec4(shuffle)).x;
  uint index = bitfieldReverse(reversedIndex);
  return bitfieldReverse(owenPermute(uvec4(index, reversedSobolPoint(index)), seeds));
}

uint high32(uint a, uint b) {
  uint high, low;
  umulExtended(a, b, high, low);
  return high;
}

// Kensler, "Correlated Multi-Jittered Sampling", Pixar 13-01: a permutation of 0..count-1 chosen by `key`.
uint permute(uint i, uint count, uint key) {
  uint w = count - 1u;
  w |= w >> 1;
  w |= w >> 2;
  w |= w >> 4;
  w |= w >> 8;
  w |= w >> 16;
  bool inside = false;
  for (uint iteration = 0u; iteration < 32u && !inside; ++iteration) {
    i ^= key;
    i *= 0xe170893du;
    i ^= key >> 16;
    i ^= (i & w) >> 4;
    i ^= key >> 8;
    i *= 0x0929eb3fu;
    i ^= key >> 23;
    i ^= (i & w) >> 1;
    i *= 1u | (key >> 27);
    i *= 0x6935fa69u;
    i ^= (i & w) >> 11;
    i *= 0x74dcb303u;
    i ^= (i & w) >> 2;
    i *= 0x9e501cc3u;
    i ^= (i & w) >> 2;
    i *= 0xc860a3dfu;
    i &= w;
    i ^= i >> 5;
    inside = i < count;
    if (inside) break;  // docs/driver-workarounds.md section 3
  }
  return (i % count + key % count) % count;
}

// Returns the first word of stratum `cell` of `count`. For cell = count, the result wraps to 0.
uint stratumStart(uint cell, uint count) {
  uint quotient = 0xffffffffu / count;
  uint remainder = 0xffffffffu - quotient * count + 1u;
  if (remainder == count) {
    quotient += 1u;
    remainder = 0u;
  }
  return cell * quotient + (cell * remainder) / count;
}

uint stratum(uint cell, uint count, uint jitter) {
  uint start = stratumStart(cell, count);
  return start + high32(jitter, stratumStart(cell + 1u, count) - start);
}

uvec2 stratifyPair(SampleKey key, uint strata, uint permutationKey, uvec2 jitter) {
  uint cell = permute(key.sampleIndex, strata * strata, permutationKey);
  return uvec2(stratum(cell % strata, strata, jitter.x), stratum(cell / strata, strata, jitter.y));
}

uint stratifySingle(SampleKey key, uint strata, uint permutationKey, uint jitter) {
  uint count = strata * strata;
  return stratum(permute(key.sampleIndex, count, permutationKey), count, jitter);
}

// Returns a group of stratified numbers. Groups differ in which dimensions form pairs: the first group of a vertex is
// (1, 2, 1), those of the environment are (2, 2), all others are (2, 2) or (2, 1, 1).
uvec4 stratifiedGroup(SampleKey key, uint group) {
  uvec4 jitter = pcg4d(uvec4(key.pixel, key.sampleIndex, group, key.seed));
  uint n = key.strata;
  if (n < 2u || key.sampleIndex >= n * n) return jitter;
  uvec4 keys = pcg4d(uvec4(key.pixel, 1u, group, key.seed ^ kScrambleSeed));
  const uint firstVertexGroup = kCameraDimensionCount / kGroupSize;
  bool isEnvironment = kHasEnvironment && group / (kEnvironmentDimensions / kGroupSize) == 1u;
  if (!isEnvironment && group >= firstVertexGroup && (group - firstVertexGroup) % 2u == 0u) {
    uint first = stratifySingle(key, n, keys.x, jitter.x);
    uvec2 middle = stratifyPair(key, n, keys.y, jitter.yz);
    return uvec4(first, middle, stratifySingle(key, n, keys.w, jitter.w));
  }
  if (group == 1u) {
    return uvec4(stratifySingle(key, n, keys.x, jitter.x), stratifySingle(key, n, keys.y, jitter.y),
                 stratifySingle(key, n, keys.z, jitter.z), stratifySingle(key, n, keys.w, jitter.w));
  }
  uvec2 first = stratifyPair(key, n, keys.x, jitter.xy);
  if (group == 0u || isEnvironment) return uvec4(first, stratifyPair(key, n, keys.z, jitter.zw));
  return uvec4(first, stratifySingle(key, n, keys.z, jitter.z), stratifySingle(key, n, keys.w, jitter.w));
}

// Returns the words of dimensions 4 group .. 4 group + 3.
uvec4 sampleGroup(SampleKey key, uint group) {
  if (kSampler == kSamplerIndependent) return pcg4d(uvec4(key.pixel, key.sampleIndex, group, key.seed));
  if (kSampler == kSamplerStratified) return stratifiedGroup(key, group);
  return sobolGroup(key, group);
}

// Returns the group of a vertex's dimension. depth counts from 1.
uint vertexGroup(uint depth, uint dimension) {
  return (kCameraDimensionCount + (depth - 1u) * kVertexDimensionCount + dimension) / kGroupSize;
}

// Returns the group of a vertex's numbers for the environment: tap x, y and point x, y.
uint environmentGroup(uint depth) {
  return (kEnvironmentDimensions + (depth - 1u) * kEnvironmentDimensionCount) / kGroupSize;
}

#endif
