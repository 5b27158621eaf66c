// Entry point of the wavefront's stage that shades the hits of the paths' rays: everything up to the next ray, except
// for the shadow ray, which is enqueued.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "wavefront.glsl"
#include "hit_list.glsl"

void storeShadowRay(uint pixelIndex, ShadowRay shadow) {
  waves[pixelIndex].shadowLimit = floatBitsToUint(vec4(shadow.ray.origin, shadow.end.distance));
  waves[pixelIndex].shadowDirection = uvec4(floatBitsToUint(shadow.ray.direction), shadow.ray.originSlot);
  waves[pixelIndex].shadowLight = uvec4(floatBitsToUint(shadow.radiance), shadow.end.light);
  if (kHasInstances) waves[pixelIndex].path.instances.z = shadow.ray.originInstance;
  if (kHasTouched) lightPointOf(waves[pixelIndex]) = floatBitsToUint(shadow.end.point);
}

// Records the decisions. Whether the shadow ray is occluded is not known yet.
void record(uint pixelIndex, uint depth, Decisions decisions) {
  if (depth > kRecordedVertices) return;
  uint word = recordWord(pixelIndex, depth);
  uvec2 packed = packDecisions(decisions);
  words[word] = packed.x;
  words[word + 1u] = packed.y;
}

void main() {
  uint pixelIndex;
  if (!takePixel(queueNow(), gl_WorkGroupID.xy, gl_LocalInvocationIndex, pixelIndex)) return;
  PathState state = waves[pixelIndex].path;
  uvec3 found = hitOf(waves[pixelIndex]);
  Path path = unpackPath(state);
  RayCounts counts = RayCounts(0u, 0u, 0u);
  Work work = Work(0u, 0u);
  uint depth = path.depth;
  bool changesLayers = kLayerSums != 0u && (depth <= 2u || kThroughSpecular);
  if (changesLayers) loadPendingLayers(pixelIndex);
  SampleKey key = sampleKeyOf(pixelAt(pixelIndex), sampleIndexOf(state));
  Decisions decisions;
  ShadowRay shadow;
  float t = uintBitsToFloat(found.x);
  Hit hit = Hit(t, found.y, found.z, kHasInstances ? state.instances.y : 0u, false, t);
  bool continues = shadeHit(path, hit, key, work, counts, decisions, shadow);
  if (changesLayers) storeLayers(pixelIndex);
  PathCounts sums = waves[pixelIndex].path.counts;
  sums = PathCounts(sums.bounceRays + counts.bounce, sums.shadowRays + counts.shadow, sums.vertices + counts.vertices,
                    sums.steps);
  waves[pixelIndex].path = packPath(path, sampleIndexOf(state), sums);
  if (kLimitsLoops && work.truncated > 0u) atomicAdd(counters.truncated, work.truncated);
  if (kHasVolumes && volumeFaults > 0u) atomicAdd(counters.volumeFaults, volumeFaults);
  if (kRecordPaths || kHasTransparency || kCountsHits) {
    shadedDepthOf(waves[pixelIndex]) = decisions.index == kRecordMiss ? depth - 1u : depth;
  }
  if (kRecordPaths) record(pixelIndex, depth, decisions);
  if (kListsHits && (depth == 1u || kThroughSpecular)) {
    listHit(pixelIndex, sampleIndexOf(state), depth, decisions.index);
  }
  if (continues) pushPixel(queueOfNextRound(), pixelIndex);
  else pushPixel(kQueueRenew, pixelIndex);
  if (!kHasLights || !shadow.wanted) return;
  storeShadowRay(pixelIndex, shadow);
  pushPixel(kQueueShadow, pixelIndex);
}
