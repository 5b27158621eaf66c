// Reads and writes at and beyond the end of buffers, which robust access confines. `inputs` has the indices.
#version 460

layout(constant_id = 0) const uint kFunction = 0u;
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 0, std430) readonly buffer Inputs { uint inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { uvec4 outputs[]; };
layout(set = 0, binding = 2, std430) buffer Words { uint words[]; };
layout(set = 0, binding = 3, std430) buffer Vectors { uvec4 vectors[]; };
layout(set = 0, binding = 4) uniform usamplerBuffer texels;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  uint index = inputs[i];
  switch (kFunction) {
    case 0u: outputs[i] = uvec4(words[index]); break;
    case 1u: outputs[i] = vectors[index]; break;
    case 2u: outputs[i] = texelFetch(texels, int(index)); break;
    case 3u: words[index] = 0x5ea1ed00u + i; break;
    case 4u: atomicAdd(words[index], 1u); break;
    case 5u: outputs[i] = uvec4(words.length(), vectors.length(), textureSize(texels), 0u); break;
  }
}
