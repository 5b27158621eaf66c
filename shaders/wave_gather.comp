// Entry point of the wavefront's first stage, once for each of its submissions: puts every pixel of the region that has
// samples left into a queue.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "wavefront.glsl"

// The queue in which the pixel begins: its path goes on, or it has none yet.
uint firstQueue(uint pixelIndex) {
  if (waves[pixelIndex].path.radianceSample.w >= dispatch.work.z) return kNoQueue;
  return waves[pixelIndex].path.throughputDepth.w > 0u ? queueOfNextRound() : kQueueRenew;
}

void main() {
  uvec2 inRegion = gl_GlobalInvocationID.xy;
  uvec2 pixel = dispatch.region.xy + inRegion;
  uint pixelIndex = (pixel.y - dispatch.work.x) * constants.imageSeed.x + pixel.x;
  uint next = kNoQueue;
  if (all(lessThan(inRegion, dispatch.region.zw))) next = firstQueue(pixelIndex);
  pushPixel(gl_LocalInvocationIndex, pixelIndex, next, false);
}
