// Lists of the primitives that the camera rays of a pixel hit, from which the host counts ids (docs/layers.md). They are
// behind the sums of layers, in the film of the band.
#ifndef CANDELA_HIT_LIST_GLSL
#define CANDELA_HIT_LIST_GLSL
#include "dispatch.glsl"

layout(set = 0, binding = kBindingFilm, std430) buffer HitLists { uint listedHits[]; };

// Stores the primitive of a sample; kRecordMiss: none. Storing it twice does no harm.
void listHit(uint pixelIndex, uint sampleIndex, uint primitive) {
  uint first = dispatch.bandPixels * (kFilmRows + (kLayerSums != 0u ? kLayerRows : 0u)) * 4u;
  listedHits[first + pixelIndex * kListedHits + sampleIndex % kListedHits] = primitive;
}

#endif
