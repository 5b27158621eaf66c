// Entry point of the wavefront's stage that traces the rays of paths.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "wavefront.glsl"

void main() {
  uint pixelIndex;
  if (!takePixel(queueNow(), gl_WorkGroupID.xy, gl_LocalInvocationIndex, pixelIndex)) return;
  uvec4 direction = waves[pixelIndex].path.directionAndSlot;
  Ray ray = makeRay(uintBitsToFloat(waves[pixelIndex].path.originPdf.xyz), uintBitsToFloat(direction.xyz), direction.w);
  if (kHasInstances) ray.originInstance = waves[pixelIndex].path.instances.x;
  if (kHasTransparency) {
    SampleKey key = sampleKeyOf(pixelAt(pixelIndex), sampleIndexOf(waves[pixelIndex].path));
    ray.opacityKey = opacityKey(key, depthOf(waves[pixelIndex].path), false);
  }
  Work work = Work(0u, 0u);
  Hit hit = traceClosest(ray, work);
  hitOf(waves[pixelIndex]) = uvec3(floatBitsToUint(hit.t), hit.slot, hit.index);
  if (kHasInstances) waves[pixelIndex].path.instances.y = hit.instance;
  addSteps(pixelIndex, work);
}
