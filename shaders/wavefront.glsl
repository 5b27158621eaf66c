// Declarations that the stages of the wavefront path tracer share (Laine, Karras and Aila, Megakernels Considered
// Harmful, HPG 2013): the states of paths, and the queues of pixels that are pending for a stage. A segment is four
// dispatches: wave_extend traces the paths' rays, wave_shade shades their hits, wave_shadow traces shadow rays, and
// wave_renew replaces paths that ended by the pixel's next sample. Each invocation of a dispatch has a pixel that needs
// the dispatch's stage.
#ifndef CANDELA_WAVEFRONT_GLSL
#define CANDELA_WAVEFRONT_GLSL
#define CANDELA_HAS_FILM
#include "dispatch.glsl"
#include "path_state.glsl"

layout(set = 0, binding = kBindingPathStates, std430) buffer WaveStates { WaveState waves[]; };
layout(set = 0, binding = kBindingResults, std430) buffer Results {
  Counters counters;
  QueueHeader headers[kQueueCount];
  uint words[];
};

uint extendQueue(uint parity) { return parity == 0u ? kQueueExtendEven : kQueueExtendOdd; }
uint queueNow() { return extendQueue(dispatch.roundParity); }
uint queueOfNextRound() { return extendQueue(1u - dispatch.roundParity); }

// Number of invocations of a workgroup.
uint laneCount() { return gl_WorkGroupSize.x * gl_WorkGroupSize.y; }

uint queueWord(uint queue, uint position) { return queue * dispatch.bandPixels + position; }

// Takes the pixel of a workgroup's invocation `lane` from a queue. Returns false if the queue has fewer pixels.
bool takePixel(uint queue, uvec2 group, uint lane, out uint pixelIndex) {
  uint position = (group.y * kGroupsPerRow + group.x) * laneCount() + lane;
  bool taken = position < headers[queue].count;
  pixelIndex = taken ? words[queueWord(queue, position)] : 0u;
  return taken;
}

// Puts a pixel into a queue. The invocation that fills the first position of a workgroup also requests that workgroup.
void pushPixel(uint queue, uint pixelIndex) {
  uint position = atomicAdd(headers[queue].count, 1u);
  words[queueWord(queue, position)] = pixelIndex;
  if (position % laneCount() != 0u) return;
  uint group = position / laneCount();
  atomicMax(headers[queue].groupsX, min(group + 1u, kGroupsPerRow));
  atomicMax(headers[queue].groupsY, group / kGroupsPerRow + 1u);
}

uvec2 pixelAt(uint pixelIndex) {
  uint width = constants.imageWidth;
  return uvec2(dispatch.firstColumn + pixelIndex % width, dispatch.firstRow + pixelIndex / width);
}

void addSteps(uint pixelIndex, Work work) {
  waves[pixelIndex].path.counts.steps += work.steps;
  if (kLimitsLoops && work.truncated > 0u) atomicAdd(counters.truncated, work.truncated);
}

// Returns the offset in `words` of a path record; the records follow the queues: see `records` in lanes.glsl.
uint recordWord(uint pixelIndex, uint depth) {
  return queueWord(kQueueCount, 0u) + 2u * (pixelIndex * kRecordedVertices + depth - 1u);
}

#endif
