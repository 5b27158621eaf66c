// Camera rays: docs/light-transport.md section 3.
#ifndef CANDELA_CAMERA_GLSL
#define CANDELA_CAMERA_GLSL
#include "sampler.glsl"
#include "sampling.glsl"
#include "scene_access.glsl"

vec2 sampleLens(vec2 u) {
  if (kLens == kLensDisc) return sampleDisc(u).xy;
  return 2.0 * u - 1.0;
}

// The ray of one sample of a pixel; numbers are those of filter x, y and lens u, v.
void cameraRay(uvec2 pixel, vec4 numbers, out vec3 origin, out vec3 direction) {
  vec2 offset = kTentFilter ? vec2(sampleTent(numbers.x), sampleTent(numbers.y)) : numbers.xy - 0.5;
  vec2 raster = (vec2(pixel) + 0.5 + offset) * vec2(constants.cameraRight.w, constants.cameraUp.w);
  precise vec3 toPlane = constants.cameraForward.xyz + (raster.x - 0.5) * constants.cameraRight.xyz +
                         (0.5 - raster.y) * constants.cameraUp.xyz;
  origin = constants.cameraOrigin.xyz;
  if (kLens != kLensNone) {
    vec2 lens = sampleLens(numbers.zw);
    vec3 shift = lens.x * constants.lensRight.xyz + lens.y * constants.lensUp.xyz;
    origin += shift;
    toPlane -= shift * constants.lensRight.w;
  }
  direction = unit(toPlane);
}

#endif
