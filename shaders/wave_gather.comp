// Entry point of the wavefront's first stage, which runs once in each submission: it puts every pixel of the region
// that has samples left into a queue.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "wavefront.glsl"

void main() {
  uvec2 inRegion = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(inRegion, dispatch.regionSize))) return;
  uint pixelIndex = pixelIndexOf(dispatch.regionOrigin + inRegion);
  if (sampleIndexOf(waves[pixelIndex].path) >= dispatch.sampleEnd) return;
  bool hasPath = depthOf(waves[pixelIndex].path) > 0u;
  if (hasPath) pushPixel(queueOfNextRound(), pixelIndex);
  else pushPixel(kQueueRenew, pixelIndex);
}
