// The scrambled Sobol sequence: docs/light-transport.md section 1.
#ifndef CANDELA_SOBOL_GLSL
#define CANDELA_SOBOL_GLSL
#include "sobol_points.glsl"
#include "sample_key.glsl"

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

#endif
