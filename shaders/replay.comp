// Entry point of the replay: one invocation traces one sample of one pixel again, with the same functions as path.comp,
// and stores what the path computes at each vertex. When it reaches its maximum number of segments or loop iterations,
// it continues in the next dispatch.
#version 460
#extension GL_GOOGLE_include_directive : require
#define CANDELA_TRACES_PATHS
#include "path_state.glsl"

layout(local_size_x = 1, local_size_y = 1, local_size_z = 1) in;
layout(push_constant) uniform Dispatch { DispatchConstants dispatch; };
layout(set = 0, binding = kBindingPathStates, std430) buffer PathStates { PathState pathState; };
layout(set = 0, binding = kBindingResults, std430) buffer Results {
  Counters counters;
  TracedSample trace;
};

void startVertex(Path path, SampleKey key) {
  const vec4 none = vec4(0.0);
  const uvec4 noWords = uvec4(0u);
  traced = TracedVertex(vec4(path.ray.origin, 0.0), vec4(path.ray.direction, path.pdf),
                        uvec4(floatBitsToUint(path.throughput), 0u), noWords, noWords, noWords, none, none, noWords, none,
                        none, none, none, none, sampleGroup(key, vertexGroup(path.depth, kDimensionLightChoice)),
                        sampleGroup(key, vertexGroup(path.depth, kDimensionBsdfU)));
}

// A direction below the surface ends the path and is not reported. If roulette was played, the direction was above it.
void finishVertex(uint depth, vec3 radiance, Decisions decisions, bool continues) {
  bool played = (traced.throughputStages.w & kTracedRoulette) != 0u;
  noteStage((continues || played ? kTracedScatter : 0u) | (decisions.survived ? kTracedSurvived : 0u));
  traced.radiance = vec4(radiance, 0.0);
  if (depth <= kTracedVertices) trace.vertices[depth - 1u] = traced;
}

void main() {
  uvec2 pixel = dispatch.regionOrigin;
  PathState state = pathState;
  uint sampleIndex = sampleIndexOf(state);
  SampleKey key = sampleKeyOf(pixel, sampleIndex);
  Path path = unpackPath(state);
  if (path.depth == 0u) startPath(path, key, pixel);
  RayCounts counts = RayCounts(0u, 0u, 0u);
  Work work = Work(0u, 0u);
  uint segments = 0u;
  uint depth = 0u;
  bool continues = true;
  bool working = true;
  uint cutShort = 1u;  // docs/driver-workarounds.md section 4
  while (working) {
    depth = path.depth;
    startVertex(path, key);
    Decisions decisions;
    continues = extendPath(path, key, work, counts, decisions);
    finishVertex(depth, path.radiance, decisions, continues);
    segments += 1u;
    working = continues && segments < dispatch.maxSegments && work.steps + segments < dispatch.maxIterations;
    cutShort = working ? 1u : 0u;
    if (kMasksLanes && !working) break;
  }
  uint truncated = kLimitsLoops ? work.truncated + cutShort : 0u;
  pathState = packPath(path, sampleIndex, state.counts);
  counters.truncated += truncated;
  trace.cameraNumbers = sampleGroup(key, 0u);
  if (!continues) {
    trace.radianceCount = uvec4(floatBitsToUint(path.radiance), depth);
    counters.finishedSamples = 1u;
  }
}
