// Writes the means of a film to the picture that a window shows: the same as view::show() in host/app/view/picture.h.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/render_data.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, set = 0, binding = 0) readonly buffer FilmBuffer { FilmRows film[]; };
layout(std430, set = 0, binding = 1) writeonly buffer PictureBuffer { vec4 picture[]; };

layout(push_constant) uniform Push {
  uvec2 filmSize;
  uvec2 pictureSize;
  float radianceOfOne;  // 2^k with the film's scale k
} push;

// The sum of a channel in units of 2^-40, as in host/image/fixed_sum.h.
float valueOf(uvec3 sum) {
  return float(sum.z) * 16777216.0 + float(sum.y) * (1.0 / 256.0) + float(sum.x) * (1.0 / 1099511627776.0);
}

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x >= push.pictureSize.x || at.y >= push.pictureSize.y) return;
  uvec2 position = at * push.filmSize / push.pictureSize;
  FilmRows pixel = film[position.y * push.filmSize.x + position.x];
  uint samples = pixel.red.w;
  if (samples == 0u) return;
  vec3 mean = vec3(valueOf(pixel.red.xyz), valueOf(pixel.green.xyz), valueOf(pixel.blue.xyz)) / float(samples) * push.radianceOfOne;
  uint scale = (push.pictureSize.x + push.filmSize.x - 1u) / push.filmSize.x;
  picture[at.y * push.pictureSize.x + at.x] = vec4(mean, scale == 1u ? float(samples) : -float(scale));
}
