// Warps and elementary functions, for comparison with the reference's and with the C library's.
// Input: (u, v, w, cap height). Output, four rows: disc and triangle; cap and tent; log(1 - u), exp(-50 v) - 1, height of a
// cosine-weighted direction, and Gaussian; a frame's image of the cap direction.
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
  vec3 normal = sampleCap(u.zx, 2.0);
  vec3 direction = sampleCap(u.xy, u.w);
  outputs[4u * i] = vec4(sampleDisc(u.xy).xy, sampleTriangle(u.xy));
  outputs[4u * i + 1u] = vec4(direction, sampleTent(u.x));
  outputs[4u * i + 2u] = vec4(logOneMinus(u.x), expMinusOne(-50.0 * u.y), sampleCosineHemisphere(u.xy).z, sampleGaussian(u.x));
  outputs[4u * i + 3u] = vec4(frameAround(unit(normal)) * direction, 0.0);
}
