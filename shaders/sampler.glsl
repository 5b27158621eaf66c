// Random numbers as a pure function of (seed, pixel, sample, dimension): docs/light-transport.md section 1.
#ifndef CANDELA_SAMPLER_GLSL
#define CANDELA_SAMPLER_GLSL
#include "sobol.glsl"
#include "strata.glsl"

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
