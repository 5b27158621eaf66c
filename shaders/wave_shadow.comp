// Entry point of the wavefront's stage that traces shadow rays and adds their contributions.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "wavefront.glsl"

Ray loadShadowRay(uint pixelIndex) {
  uvec4 direction = waves[pixelIndex].shadowDirection;
  Ray ray = makeRay(uintBitsToFloat(waves[pixelIndex].shadowLimit.xyz), uintBitsToFloat(direction.xyz), direction.w);
  if (kHasInstances) ray.originInstance = waves[pixelIndex].path.instances.z;
  if (kHasTransparency) {
    SampleKey key = sampleKeyOf(pixelAt(pixelIndex), sampleIndexOf(waves[pixelIndex].path));
    ray.opacityKey = opacityKey(key, shadedDepthOf(waves[pixelIndex]), true);
  }
  return ray;
}

RayEnd loadEnd(uint pixelIndex) {
  vec3 point = kNoPoint;
  if (kHasTouched) point = uintBitsToFloat(lightPointOf(waves[pixelIndex]));
  return RayEnd(uintBitsToFloat(waves[pixelIndex].shadowLimit.w), waves[pixelIndex].shadowLight.w, point);
}

void main() {
  uint pixelIndex;
  if (!takePixel(kQueueShadow, gl_WorkGroupID.xy, gl_LocalInvocationIndex, pixelIndex)) return;
  Work work = Work(0u, 0u);
  bool blocked = traceAny(loadShadowRay(pixelIndex), loadEnd(pixelIndex), work);
  if (!blocked) {
    vec3 radiance = uintBitsToFloat(radianceBitsOf(waves[pixelIndex].path));
    radiance += uintBitsToFloat(waves[pixelIndex].shadowLight.xyz);
    radianceBitsOf(waves[pixelIndex].path) = floatBitsToUint(radiance);
  }
  addSteps(pixelIndex, work);
  if (!kRecordPaths) return;
  uint depth = shadedDepthOf(waves[pixelIndex]);
  uint outcome = blocked ? kShadowOccluded : kShadowVisible;
  if (depth <= kRecordedVertices) words[recordWord(pixelIndex, depth) + 1u] |= outcome << 8;
}
