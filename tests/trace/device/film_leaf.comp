// Sums of samples as in the film: each invocation adds `perLane` consecutive inputs.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "film.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint perLane; };
layout(set = 0, binding = 0, std430) readonly buffer Inputs { vec4 inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { FilmRows outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  FilmRows film = FilmRows(uvec4(0u), uvec4(0u), uvec4(0u), uvec4(0u));
  for (uint k = 0u; k < perLane; ++k) addSample(film, inputs[i * perLane + k].xyz, k);
  outputs[i] = film;
}
