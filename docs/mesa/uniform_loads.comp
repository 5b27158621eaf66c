// Loads records of 16 bytes, at an index that is the same for all invocations of a subgroup or differs between them.
//
// INDEX 0: it differs. 1: it is the result of subgroupBroadcastFirst(). 2: it follows from push constants and the number of the iteration.
// LOADS: number of loads. TEXELS: they read a texel buffer, else a storage buffer. LOOP: they are in a loop, which
// invocations leave in different iterations; else in no control flow.
#version 460
#extension GL_KHR_shader_subgroup_ballot : require

layout(local_size_x = 8) in;
layout(push_constant) uniform Push { uint rounds, first; } push;
layout(set = 0, binding = 0) buffer Words { uint words[]; };
#ifdef TEXELS
layout(set = 0, binding = 1) uniform utextureBuffer texels;
uvec4 record(uint index) { return texelFetch(texels, int(index)); }
#else
layout(set = 0, binding = 1, std430) readonly buffer Records { uvec4 records[]; };
uvec4 record(uint index) { return records[index]; }
#endif

uint indexOf(uint state, uint round) {
#if INDEX == 0
  return (state + round) & 255u;
#elif INDEX == 1
  return subgroupBroadcastFirst((state + round) & 255u);
#else
  return (push.first + round) & 255u;
#endif
}

uint loaded(uint index) {
  uint sum = 0u;
#define LOAD(k) \
  if (k < LOADS) { \
    uvec4 four = record(index + 5u * k); \
    sum += (four.x ^ four.y) + (four.z ^ four.w); \
  }
  LOAD(0u) LOAD(1u) LOAD(2u) LOAD(3u) LOAD(4u) LOAD(5u) LOAD(6u) LOAD(7u)
  return sum;
}

void main() {
  uint lane = gl_LocalInvocationIndex;
  uint state = lane * 16u;
#ifdef LOOP
  for (uint round = 0u; round < push.rounds + lane; ++round) state += loaded(indexOf(state, round));
#else
  state += loaded(indexOf(state, push.rounds));
#endif
  words[gl_GlobalInvocationID.x & 1023u] = state;
}
