// One use of memory for each value of kFunction. Invocations of all workgroups share `data`.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "conformance/chain.glsl"

layout(constant_id = 0) const uint kFunction = 0u;
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint parameter; };
layout(set = 0, binding = 0, std430) coherent buffer Data { uint data[]; };
layout(set = 0, binding = 1, std430) buffer Outputs { uint outputs[]; };

const uint kGroupSize = 64u;
const uint kMaxTries = 20000u;
shared uint sharedWords[kGroupSize];
shared uint sharedCount;

// Each position is taken by one invocation.
void takePositions(uint i) { outputs[i] = atomicAdd(data[i % parameter], 1u); }

void combineBits(uint i) {
  uint word = next(i);
  atomicOr(data[0], (1u << (word & 31u)) & 0x2d5b6a97u);
  atomicAnd(data[1], ~((1u << (i & 31u)) & 0x1badcafeu));
  atomicXor(data[2], word);
  atomicMin(data[3], word);
  atomicMax(data[4], word);
  atomicAdd(data[5], word);
}

// Each value is passed on once: the outputs and the last value are a permutation.
void exchangeValues(uint i) { outputs[i] = atomicExchange(data[i % parameter], i + 1u); }

// A sum by compare and swap.
void addBySwap(uint i) {
  uint seen = data[i % parameter];
  bool added = false;
  for (uint tries = 0u; tries < kMaxTries && !added; ++tries) {
    uint old = atomicCompSwap(data[i % parameter], seen, seen + next(i));
    added = old == seen;
    seen = old;
  }
  outputs[i] = added ? 1u : 0u;
}

// Inclusive prefix sums of a workgroup.
void scan(uint i, uint local) {
  uint sum = next(i) >> 8;
  sharedWords[local] = sum;
  barrier();
  for (uint distance = 1u; distance < kGroupSize; distance *= 2u) {
    uint other = local >= distance ? sharedWords[local - distance] : 0u;
    barrier();
    sum += other;
    sharedWords[local] = sum;
    barrier();
  }
  outputs[i] = sum;
}

// The invocations whose word is odd form a list in shared memory, which the first invocation adds up.
void listInShared(uint i, uint local) {
  if (local == 0u) sharedCount = 0u;
  barrier();
  if (((next(i) >> 20) & 1u) != 0u) sharedWords[atomicAdd(sharedCount, 1u)] = i;
  barrier();
  if (local != 0u) return;
  uint sum = 0u;
  for (uint k = 0u; k < sharedCount; ++k) sum += sharedWords[k];
  outputs[i] = sum;
  outputs[i + 1u] = sharedCount;
}

// Words of other invocations of the workgroup, through a storage buffer.
void exchangeInStorage(uint i, uint local) {
  uint word = next(i);
  for (uint iteration = 0u; iteration < 8u; ++iteration) {
    data[i] = word;
    memoryBarrierBuffer();
    barrier();
    uint other = data[i - local + ((local * 5u + iteration) & (kGroupSize - 1u))];
    barrier();
    word = next(word ^ other);
  }
  outputs[i] = word;
}

// Reads what the invocation has just written, at indices that are equal for some invocations.
void aliased(uint i) {
  uint first = 8u * i + ((next(i) >> 20) & 7u);
  uint second = 8u * i + ((next(next(i)) >> 20) & 7u);
  data[first] = i;
  data[second] = i + 7u;
  uint seen = data[first];
  data[first] = seen * 3u;
  outputs[i] = data[second] + 5u * seen;
}

// One step of a chain of dispatches, each of which reads results of other invocations of the previous step.
void readNeighbour(uint i) { outputs[i] = next(data[(i + 37u) % count]); }

void main() {
  uint i = gl_GlobalInvocationID.x;
  uint local = gl_LocalInvocationID.x;
  switch (kFunction) {
    case 4u: scan(i, local); return;
    case 5u: listInShared(i, local); return;
    case 6u: exchangeInStorage(i, local); return;
  }
  if (i >= count) return;
  switch (kFunction) {
    case 0u: takePositions(i); break;
    case 1u: combineBits(i); break;
    case 2u: exchangeValues(i); break;
    case 3u: addBySwap(i); break;
    case 7u: aliased(i); break;
    case 8u: readNeighbour(i); break;
  }
}
