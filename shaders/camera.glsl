// Camera rays: docs/light-transport.md section 3.
#ifndef CANDELA_CAMERA_GLSL
#define CANDELA_CAMERA_GLSL
#include "sampler.glsl"
#include "sampling.glsl"
#include "scene_access.glsl"

SampleKey sampleKeyOf(uvec2 pixel, uint sampleIndex) {
  return SampleKey(pixel.x + 65536u * pixel.y, sampleIndex, constants.seed, constants.strataPerSide);
}

vec2 sampleLens(vec2 u) {
  if (kLens == kLensDisc) return sampleDisc(u).xy;
  return 2.0 * u - 1.0;
}

vec2 sampleFilter(vec2 u) {
  if (kFilter == kFilterNone) return vec2(0.0);
  if (kFilter == kFilterTent) return vec2(sampleTent(u.x), sampleTent(u.y));
  if (kFilter == kFilterGaussian)
    return uintBitsToFloat(kFilterDeviation) * vec2(sampleGaussian(u.x), sampleGaussian(u.y));
  return u - 0.5;
}

// Computes the ray of one sample of a pixel. `numbers` are filter x, filter y, lens u and lens v.
void cameraRay(uvec2 pixel, vec4 numbers, out vec3 origin, out vec3 direction) {
  vec2 pixelOrigin = vec2(constants.pixelOriginX, constants.pixelOriginY);
  vec2 inversePixels = vec2(constants.inversePixelsAcross, constants.inversePixelsDown);
  vec2 raster = (vec2(pixel) + pixelOrigin + sampleFilter(numbers.xy)) * inversePixels;
  precise vec3 centre = kHasOrthographic ? constants.cameraOrigin : constants.cameraForward;
  precise vec3 point = centre + (raster.x - 0.5) * constants.cameraRight + (0.5 - raster.y) * constants.cameraUp;
  origin = kHasOrthographic ? point : constants.cameraOrigin;
  precise vec3 toPlane = kHasOrthographic ? constants.cameraForward : point;
  if (kLens != kLensNone) {
    vec2 lens = sampleLens(numbers.zw);
    vec3 shift = lens.x * constants.lensRight + lens.y * constants.lensUp;
    origin += shift;
    toPlane -= shift * constants.inverseFocal;
  }
  direction = unit(toPlane);
}

#endif
