// The environment under proof. Input, two rows, floats as their bits: to sample, (word u, word v, place) (), to look up,
// (direction, .) (jitter, .). Output, two rows: (wi, pdf) (radiance, .), or (radiance, pdf) ().
#version 460
#extension GL_GOOGLE_include_directive : require
#include "environment.glsl"

const uint kSample = 0u;

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint task; };
layout(set = 0, binding = 1, std430) readonly buffer Inputs { uvec4 inputs[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Outputs { vec4 outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  uvec4 first = inputs[2u * i];
  if (task == kSample) {
    uint truncated = 0u;
    LightSample lit = sampleEnvironment(first.xy, uintBitsToFloat(first.zw), truncated);
    outputs[2u * i] = vec4(lit.wi, lit.pdf);
    outputs[2u * i + 1u] = vec4(lit.emission, 0.0);
  } else {
    EnvironmentTap tap = environmentTap(uintBitsToFloat(first.xyz), uintBitsToFloat(inputs[2u * i + 1u].xy));
    outputs[2u * i] = vec4(tap.radiance, tap.pdf);
  }
}
