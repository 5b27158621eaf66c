// Random words of (pixel, sample, group, seed), for comparison with the reference's sampler.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "sampler.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint strata; };
layout(set = 0, binding = 0, std430) readonly buffer Inputs { uvec4 inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { uvec4 outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  uvec4 key = inputs[i];
  outputs[i] = sampleGroup(SampleKey(key.x, key.y, key.w, strata), key.z);
}
