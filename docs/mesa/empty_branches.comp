// Each iteration branches around 80 operations of integers. The first `lanes` of the eight invocations execute them.
//
// CONDITION 0: the lane is below `lanes`. 1: some lane of the subgroup is. 2: `lanes` is not 0, a value of the push constants.
// With WITHOUT_BODY, the branch is absent.
#version 460
#if CONDITION == 1
#extension GL_KHR_shader_subgroup_vote : require
#endif

layout(local_size_x = 8) in;
layout(push_constant) uniform Push { uint rounds, lanes; } push;
layout(set = 0, binding = 0) buffer Words { uint words[]; };

#define FOUR(k) \
  x = x * 1664525u + k; \
  x ^= x >> 15;
#define TWENTY FOUR(1u) FOUR(2u) FOUR(3u) FOUR(4u) FOUR(5u)

void main() {
  uint lane = gl_LocalInvocationIndex;
  uint x = lane;
  for (uint round = 0u; round < push.rounds + lane; ++round) {
#if CONDITION == 0
    bool taken = lane < push.lanes;
#elif CONDITION == 1
    bool taken = subgroupAny(lane < push.lanes);
#else
    bool taken = push.lanes != 0u;
#endif
    x += round;
#ifndef WITHOUT_BODY
    if (taken) { TWENTY TWENTY TWENTY TWENTY }
#endif
  }
  words[gl_GlobalInvocationID.x & 1023u] = x;
}
