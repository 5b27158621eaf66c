// Candela's own elementary functions and warps. Input: (u, v, w, height of a cap). kFunction selects the output.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "sampling.glsl"

layout(constant_id = 0) const uint kFunction = 0u;
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 0, std430) readonly buffer Inputs { vec4 inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { vec4 outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  vec4 u = inputs[i];
  vec4 result = vec4(0.0);
  switch (kFunction) {
    case 0u: result = vec4(sampleDisc(u.xy).xy, sampleTriangle(u.xy)); break;
    case 1u: result = vec4(sampleCap(u.xy, u.w), 0.0); break;
    case 2u: result = vec4(sampleCosineHemisphere(u.xy), sampleTent(u.z)); break;
    case 3u: result = vec4(logOneMinus(u.x), logarithm(u.y + 0.001), 0.0, 0.0); break;
    case 4u: result = vec4(expMinusOne(-50.0 * u.y), exponential(40.0 * u.x - 20.0), 0.0, 0.0); break;
    case 5u: result = vec4(turnsOf(u.xy - 0.5), 0.0, 0.0, 0.0); break;
  }
  outputs[i] = result;
}
