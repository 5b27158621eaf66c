// to[i] = from[i + 1] + 1, around the end: every invocation reads what another one wrote a dispatch before.
#version 450

layout(local_size_x = 64) in;

layout(std430, set = 0, binding = 0) readonly buffer From {
  uint values[];
} from;
layout(std430, set = 0, binding = 1) writeonly buffer To {
  uint values[];
} to;

void main() {
  uint count = uint(from.values.length());
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  to.values[i] = from.values[(i + 1u) % count] + 1u;
}
