// The closest hit and the any-hit query, by BVH or by brute force: the result never depends on which.
#ifndef CANDELA_TRAVERSAL_GLSL
#define CANDELA_TRAVERSAL_GLSL
#include "primitives.glsl"

struct Hit {
  float t;     // kNoHit: nothing
  uint slot;
  uint index;  // primitive index: the lower wins between equal distances
};

// Work done, and whether some loop was stopped before its end (a device may limit the turns of an invocation's loops).
struct Work {
  uint steps;
  uint truncated;
};

void closer(inout Hit hit, Ray ray, uint slot) {
  PrimitiveHit candidate = hitPrimitive(ray, slot);
  bool better = candidate.t < hit.t || (candidate.t == hit.t && candidate.t < kNoHit && candidate.index < hit.index);
  hit.t = better ? candidate.t : hit.t;
  hit.slot = better ? slot : hit.slot;
  hit.index = better ? candidate.index : hit.index;
}

bool blocks(Ray ray, uint slot, uint ignored, float limit) {
  return slot != ignored && hitPrimitive(ray, slot).t < limit;
}

void closestInRange(inout Hit hit, Ray ray, uint first, uint end, inout Work work) {
  uint slot = first;
  while (slot < end) {
    closer(hit, ray, slot);
    ++slot;
  }
  work.steps += slot - first;
  work.truncated += slot < end ? 1u : 0u;
}

bool anyInRange(Ray ray, uint first, uint end, uint ignored, float limit, inout Work work) {
  uint slot = first;
  bool blocked = false;
  while (slot < end && !blocked) {
    blocked = blocks(ray, slot, ignored, limit);
    ++slot;
  }
  work.steps += slot - first;
  work.truncated += slot < end && !blocked ? 1u : 0u;
  return blocked;
}

#include "bvh.glsl"

Hit traceClosest(Ray ray, inout Work work) {
  Hit hit = Hit(kNoHit, kNoSlot, 0xffffffffu);
  if (kHierarchy) closestInHierarchy(hit, ray, work);
  else closestInRange(hit, ray, 0u, constants.moreSections.z, work);
  if (kHasPlanes) closestInRange(hit, ray, constants.moreSections.z, constants.moreSections.w, work);
  return hit;
}

// True if something but `ignored` is hit before `limit`.
bool traceAny(Ray ray, uint ignored, float limit, inout Work work) {
  if (kHasPlanes && anyInRange(ray, constants.moreSections.z, constants.moreSections.w, ignored, limit, work)) return true;
  if (kHierarchy) return anyInHierarchy(ray, ignored, limit, work);
  return anyInRange(ray, 0u, constants.moreSections.z, ignored, limit, work);
}

#endif
