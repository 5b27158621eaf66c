// Entry point of the wavefront's stage that adds the samples of ended paths to the film and starts the next sample of
// each of their pixels.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "wavefront.glsl"

// Adds the pixel's sample, if it has one, and returns the index of the next.
uint finishSample(uint pixelIndex) {
  uvec4 radianceSample = waves[pixelIndex].path.radianceSample;
  bool hasPath = depthOf(waves[pixelIndex].path) > 0u;
  if (!hasPath) return radianceSample.w;
  FilmRows sums = film[pixelIndex];
  addSample(sums, uintBitsToFloat(radianceSample.xyz), radianceSample.w);
  if (kCountsHits && shadedDepthOf(waves[pixelIndex]) > 0u) addHit(sums);
  film[pixelIndex] = sums;
  if (kLayerSums != 0u) {
    loadPendingLayers(pixelIndex);
    gatherLayers(uintBitsToFloat(radianceSample.xyz));
    storeLayers(pixelIndex);
  }
  atomicAdd(counters.finishedSamples, 1u);
  return radianceSample.w + 1u;
}

void main() {
  uint pixelIndex;
  if (!takePixel(kQueueRenew, gl_WorkGroupID.xy, gl_LocalInvocationIndex, pixelIndex)) return;
  uint sampleIndex = finishSample(pixelIndex);
  bool done = sampleIndex >= dispatch.sampleEnd;
  uvec2 pixel = pixelAt(pixelIndex);
  Path path;
  startPath(path, sampleKeyOf(pixel, sampleIndex), pixel);
  if (done) path.depth = 0u;
  waves[pixelIndex].path = packPath(path, sampleIndex, waves[pixelIndex].path.counts);
  if (done) atomicAdd(counters.finishedPixels, 1u);
  else pushPixel(queueOfNextRound(), pixelIndex);
}
