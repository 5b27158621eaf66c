// The origins of rays that start on flat surfaces. Input: position, unit normal, direction. Output: the origin.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"

struct Start {
  vec4 position;
  vec4 normal;
  vec4 direction;
};

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 0, std430) readonly buffer Inputs { Start inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { vec4 outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  Start start = inputs[i];
  outputs[i] = vec4(offsetAlong(start.position.xyz, start.normal.xyz, start.direction.xyz), 0.0);
}
