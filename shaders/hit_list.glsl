// Lists of the primitives that the camera rays of a pixel hit, from which the host counts ids (docs/layers.md). They
// are stored after the sums of layers, in the film buffer of the band.
#ifndef CANDELA_HIT_LIST_GLSL
#define CANDELA_HIT_LIST_GLSL
#include "dispatch.glsl"
#include "layers.glsl"

layout(set = 0, binding = kBindingFilm, std430) buffer HitLists { uint listedHits[]; };

// Stores the primitive that the ray of a depth has hit; kRecordMiss: none. Later rays count only while layers see
// through all surfaces before.
void listHit(uint pixelIndex, uint sampleIndex, uint depth, uint primitive) {
  uint first = dispatch.bandPixels * (kFilmRows + (kLayerSums != 0u ? kLayerRows : 0u)) * 4u;
  uint index = first + pixelIndex * kListedHits + sampleIndex % kListedHits;
  if (depth > 1u && listedHits[index] != kSeenThrough) return;
  bool isSeenThrough = kThroughSpecular && seenThrough && primitive != kRecordMiss;
  listedHits[index] = isSeenThrough ? kSeenThrough : primitive;
}

#endif
