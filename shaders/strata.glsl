// Stratified random numbers (Kensler): docs/light-transport.md section 1.
#ifndef CANDELA_STRATA_GLSL
#define CANDELA_STRATA_GLSL
#include "sample_key.glsl"

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
    if (kMasksLanes && inside) break;  // docs/driver-workarounds.md section 3
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

#endif
