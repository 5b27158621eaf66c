// Reads records of a buffer at random, in one of the ways in which a scene is read; see
// host/trace/vulkan/loads_probe.h.
#version 450

layout(constant_id = 0) const bool kTexels = false;
layout(local_size_x = 64) in;

layout(std430, set = 0, binding = 0) buffer Rows { uvec4 rows[]; };
layout(set = 0, binding = 1) uniform usamplerBuffer texels;
layout(std430, set = 0, binding = 2) buffer Results { uint results[]; };

uvec4 readRow(uint row) {
  if (kTexels) return texelFetch(texels, int(row));
  return rows[row];
}

void main() {
  uint mask = uint(textureSize(texels)) / 4u - 1u;
  uint node = gl_GlobalInvocationID.x;
  uint steps = 24u + (node & 15u);  // invocations leave the loop one after another, as those that traverse a tree
  uint step = 0u;
  while (step < steps) {
    uint row = 4u * (node & mask);
    uvec4 sum = readRow(row) + readRow(row + 1u) + readRow(row + 2u) + readRow(row + 3u);
    node = (node ^ (node >> 15)) * 0x2c1b3c6du + (sum.x ^ sum.y ^ sum.z ^ sum.w) + step;
    ++step;
  }
  results[gl_GlobalInvocationID.x] = node;
}
