// The warps under proof. Input: (u, v, ., cap height). Output, three rows: disc and triangle; cap and tent; cosine
// hemisphere and Gaussian.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "sampling.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 0, std430) readonly buffer Inputs { vec4 inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { vec4 outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  vec4 u = inputs[i];
  outputs[3u * i] = vec4(sampleDisc(u.xy).xy, sampleTriangle(u.xy));
  outputs[3u * i + 1u] = vec4(sampleCap(u.xy, u.w), sampleTent(u.x));
  outputs[3u * i + 2u] = vec4(sampleCosineHemisphere(u.xy), sampleGaussian(u.x));
}
