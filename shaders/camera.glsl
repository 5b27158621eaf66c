// Camera rays: docs/light-transport.md section 3.
#ifndef CANDELA_CAMERA_GLSL
#define CANDELA_CAMERA_GLSL
#include "sampler.glsl"
#include "sampling.glsl"
#include "scene_access.glsl"

SampleKey sampleKeyOf(uvec2 pixel, uint sampleIndex) {
  return SampleKey(pixel.x + 65536u * pixel.y, sampleIndex, constants.imageSeed.z, constants.imageSeed.w);
}

vec2 sampleLens(vec2 u) {
  if (kLens == kLensDisc) return sampleDisc(u).xy;
  return 2.0 * u - 1.0;
}

vec2 sampleFilter(vec2 u) {
  if (kFilter == kFilterNone) return vec2(0.0);
  if (kFilter == kFilterTent) return vec2(sampleTent(u.x), sampleTent(u.y));
  return u - 0.5;
}

// The ray of one sample of a pixel; numbers are those of filter x, y and lens u, v.
void cameraRay(uvec2 pixel, vec4 numbers, out vec3 origin, out vec3 direction) {
  vec2 pixelOrigin = vec2(constants.cameraOrigin.w, constants.cameraForward.w);
  vec2 raster = (vec2(pixel) + pixelOrigin + sampleFilter(numbers.xy)) * vec2(constants.cameraRight.w, constants.cameraUp.w);
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
