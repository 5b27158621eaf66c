// Fresnel's reflectance, for comparison with closed forms. Input: (cosine of incidence, relative index). Output:
// (reflectance, relative index times the cosine of refraction).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fresnel.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 0, std430) readonly buffer Inputs { vec2 inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { vec2 outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  float g;
  float reflectance = fresnelReflectance(inputs[i].x, inputs[i].y, g);
  outputs[i] = vec2(reflectance, g);
}
