// Reads members of structures with the padding of std430, and writes them as words.
#version 460

struct Part {
  vec3 a;
  float b;
  uint c[3];
  vec2 d;
  mat3 e;
  uvec3 f;
};

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 0, std430) readonly buffer Parts { Part parts[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { uvec4 outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  Part part = parts[i];
  uint k = part.c[0] % 3u;
  outputs[4u * i] = uvec4(floatBitsToUint(part.a), floatBitsToUint(part.b));
  outputs[4u * i + 1u] = uvec4(part.c[0], part.c[1], part.c[2], part.c[k]);
  outputs[4u * i + 2u] = uvec4(floatBitsToUint(part.d), floatBitsToUint(part.e[k][2]), floatBitsToUint(part.e[2][k]));
  outputs[4u * i + 3u] = uvec4(part.f, part.f[k]);
}
