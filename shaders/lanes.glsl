// The main loop of kernels whose samples are paths: one invocation per pixel. When its path ends, an invocation starts
// the pixel's next sample at once. When it reaches its maximum number of segments or loop iterations, it stores its
// path in a buffer and continues in the next dispatch.
#ifndef CANDELA_LANES_GLSL
#define CANDELA_LANES_GLSL
#define CANDELA_HAS_FILM
#include "dispatch.glsl"
#include "hit_list.glsl"
#include "path_state.glsl"

layout(set = 0, binding = kBindingPathStates, std430) buffer PathStates { PathState pathStates[]; };
layout(set = 0, binding = kBindingResults, std430) buffer Results {
  Counters counters;
  uvec2 records[];
};

// Defined by the entry point: traces the path's ray and computes everything up to the next ray. Returns true if the
// path continues.
bool extendSample(inout Path path, SampleKey key, inout Work work, inout RayCounts counts, out Decisions decisions);

void record(uint pixelIndex, uint depth, Decisions decisions) {
  if (depth > kRecordedVertices) return;
  records[pixelIndex * kRecordedVertices + depth - 1u] = packDecisions(decisions);
}

void advancePixel(uvec2 inRegion) {
  if (any(greaterThanEqual(inRegion, dispatch.regionSize))) return;
  uvec2 pixel = dispatch.regionOrigin + inRegion;
  uint pixelIndex = pixelIndexOf(pixel);
  PathState state = pathStates[pixelIndex];
  uint firstSample = sampleIndexOf(state);
  uint sampleIndex = firstSample;
  uint sampleEnd = dispatch.sampleEnd;
  if (sampleIndex >= sampleEnd) return;

  if (kLayerSums != 0u) loadPendingLayers(pixelIndex);
  Path path = unpackPath(state);
  FilmRows sums = film[pixelIndex];
  RayCounts counts = RayCounts(state.counts.bounceRays, state.counts.shadowRays, state.counts.vertices);
  Work work = Work(0u, 0u);
  uint segments = 0u;
  bool working = true;
  uint cutShort = 1u;  // docs/driver-workarounds.md section 4
  while (working) {
    SampleKey key = sampleKeyOf(pixel, sampleIndex);
    if (path.depth == 0u) startPath(path, key, pixel);
    uint depth = path.depth;
    Decisions decisions;
    bool continues = extendSample(path, key, work, counts, decisions);
    if (kRecordPaths) record(pixelIndex, depth, decisions);
    if (kListsHits && (depth == 1u || kThroughSpecular)) listHit(pixelIndex, sampleIndex, depth, decisions.index);
    if (!continues) {
      addSample(sums, path.radiance, sampleIndex);
      if (kCountsHits && (depth > 1u || decisions.index != kRecordMiss)) addHit(sums);
      if (kLayerSums != 0u) gatherLayers(path.radiance);
      path.depth = 0u;
      path.volume = 0u;
      sampleIndex += 1u;
    }
    segments += 1u;
    working = sampleIndex < sampleEnd && segments < dispatch.maxSegments && work.steps + segments < dispatch.maxIterations;
    cutShort = working ? 1u : 0u;
    if (kMasksLanes && !working) break;
  }
  uint truncated = kLimitsLoops ? work.truncated + cutShort : 0u;
  film[pixelIndex] = sums;
  if (kLayerSums != 0u) storeLayers(pixelIndex);
  pathStates[pixelIndex] = packPath(path, sampleIndex,
                                    PathCounts(counts.bounce, counts.shadow, counts.vertices, state.counts.steps + work.steps));
  if (truncated > 0u) atomicAdd(counters.truncated, truncated);
  if (kHasVolumes && volumeFaults > 0u) atomicAdd(counters.volumeFaults, volumeFaults);
  if (sampleIndex > firstSample) atomicAdd(counters.finishedSamples, sampleIndex - firstSample);
  if (sampleIndex >= sampleEnd) atomicAdd(counters.finishedPixels, 1u);
}

#endif
