// What the dispatches of all tracers have in common: their workgroups, their constants, the film, and where a pixel's
// state and sums stand.
#ifndef CANDELA_DISPATCH_GLSL
#define CANDELA_DISPATCH_GLSL
#include "film.glsl"
#include "scene_access.glsl"

layout(local_size_x_id = kSpecWorkgroupX, local_size_y_id = kSpecWorkgroupY, local_size_z = 1) in;
layout(push_constant) uniform Dispatch { DispatchConstants pushed; };
DispatchConstants dispatch = pushed;  // docs/driver-workarounds.md section 1
layout(set = 0, binding = kBindingFilm, std430) buffer Film { FilmRows film[]; };

// Of a pixel of the image, in the band.
uint pixelIndexOf(uvec2 pixel) { return (pixel.y - dispatch.firstRow) * constants.imageWidth + pixel.x; }

#endif
