// Queues of work between dispatches, as in the wavefront kernel: the entries of one queue are read, and either
// enqueued for the next round or finished. The header has the workgroup counts of an indirect dispatch.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "conformance/chain.glsl"

struct Header {
  uint groupsX, groupsY, groupsZ;
  uint count;
};

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint items; uint round; };
layout(set = 0, binding = 0, std430) buffer Headers { Header headers[2]; };
layout(set = 0, binding = 1, std430) buffer Queues { uint queues[]; };
layout(set = 0, binding = 2, std430) buffer Items { uvec2 states[]; };

void push(uint item, uint queue) {
  uint position = atomicAdd(headers[queue].count, 1u);
  queues[queue * items + position] = item;
  if (position % gl_WorkGroupSize.x == 0u) atomicAdd(headers[queue].groupsX, 1u);
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  uint from = round & 1u;
  uint available = round == 0u ? items : headers[from].count;
  if (i >= available) return;
  uint item = round == 0u ? i : queues[from * items + i];
  uint state = next(states[item].x);
  states[item] = uvec2(state, states[item].y + 1u);
  if ((state >> 29) != 0u) push(item, from ^ 1u);
}
