// Closest hits under proof. Input, two rows: (origin, .) (direction, .). Output: (distance, primitive index or
// kRecordMiss, truncated, 0), the first as its bits.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "traversal.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 1, std430) readonly buffer Inputs { vec4 inputs[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Outputs { uvec4 outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  Work work = Work(0u, 0u);
  Hit hit = traceClosest(makeRay(inputs[2u * i].xyz, inputs[2u * i + 1u].xyz, kNoSlot), work);
  bool missed = hit.t >= kNoHit;
  outputs[i] = uvec4(floatBitsToUint(hit.t), missed ? kRecordMiss : hit.index, work.truncated, 0u);
}
