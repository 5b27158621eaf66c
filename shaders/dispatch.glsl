// Declarations that the dispatches of all integrators share: the workgroup size, the push constants, the film, and the
// index of a pixel in the buffers of the band.
#ifndef CANDELA_DISPATCH_GLSL
#define CANDELA_DISPATCH_GLSL
#include "film.glsl"
#include "scene_access.glsl"

layout(local_size_x_id = kSpecWorkgroupX, local_size_y_id = kSpecWorkgroupY, local_size_z = 1) in;
#define CANDELA_SHARES_STACK
layout(push_constant) uniform Dispatch { DispatchConstants pushed; };
DispatchConstants dispatch = pushed;  // docs/driver-workarounds.md section 1
layout(set = 0, binding = kBindingFilm, std430) buffer Film { FilmRows film[]; };

// Returns the index in the band of a pixel of the image.
uint pixelIndexOf(uvec2 pixel) {
  return (pixel.y - dispatch.firstRow) * constants.imageWidth + pixel.x - dispatch.firstColumn;
}

#endif
