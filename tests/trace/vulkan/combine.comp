// Combines a number from every way into a shader: texel buffer, uniform buffer, push and specialisation constants.
#version 450

layout(local_size_x_id = 0) in;
layout(constant_id = 1) const uint kFactor = 1u;

layout(set = 0, binding = 0) uniform usamplerBuffer source;
layout(std430, set = 0, binding = 1) writeonly buffer Result {
  uint values[];
} result;
layout(std140, set = 0, binding = 2) uniform Offset {
  uvec4 offset;
};
layout(push_constant) uniform Push {
  uint summand;
  uint count;
};

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  result.values[i] = kFactor * texelFetch(source, int(i / 4u))[i % 4u] + summand + offset.w;
}
