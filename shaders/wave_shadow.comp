// Entry point of the wavefront's stage that traces shadow rays and adds their contributions.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "wavefront.glsl"

ShadowRay loadShadowRay(uint pixelIndex) {
  uvec4 origin = waves[pixelIndex].shadowLimit;
  uvec4 direction = waves[pixelIndex].shadowDirection;
  uvec4 light = waves[pixelIndex].shadowLight;
  Ray ray = makeRay(uintBitsToFloat(origin.xyz), uintBitsToFloat(direction.xyz), direction.w);
  if (kHasInstances) ray.originInstance = waves[pixelIndex].path.instances.z;
  vec3 point = kNoPoint;
  if (kHasTouched) point = uintBitsToFloat(lightPointOf(waves[pixelIndex]));
  return ShadowRay(true, ray, RayEnd(uintBitsToFloat(origin.w), light.w, point), uintBitsToFloat(light.xyz));
}

void main() {
  uint pixelIndex;
  if (!takePixel(kQueueShadow, gl_WorkGroupID.xy, gl_LocalInvocationIndex, pixelIndex)) return;
  vec3 radiance = uintBitsToFloat(radianceBitsOf(waves[pixelIndex].path));
  ShadowRay shadow = loadShadowRay(pixelIndex);
  if (kHasTransparency) {
    SampleKey key = sampleKeyOf(pixelAt(pixelIndex), sampleIndexOf(waves[pixelIndex].path));
    shadow.ray.opacityKey = opacityKey(key, shadedDepthOf(waves[pixelIndex]), true);
  }
  Work work = Work(0u, 0u);
  uint outcome = traceShadow(shadow, radiance, work);
  radianceBitsOf(waves[pixelIndex].path) = floatBitsToUint(radiance);
  addSteps(pixelIndex, work);
  uint depth = shadedDepthOf(waves[pixelIndex]);
  if (kRecordPaths && depth <= kRecordedVertices) words[recordWord(pixelIndex, depth) + 1u] |= outcome << 8;
}
