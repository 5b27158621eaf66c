// The closest hit and the any-hit query, by BVH, grid or brute force. The result never depends on the structure.
#ifndef CANDELA_TRAVERSAL_GLSL
#define CANDELA_TRAVERSAL_GLSL
#extension GL_EXT_control_flow_attributes : require
#include "occlusion.glsl"
#include "primitives.glsl"

// Counts of traversal steps and of loops that a device with a loop limit stopped early. docs/driver-workarounds.md,
// sections 3 and 4, explains why loops test their conditions twice, and why `truncated` is not computed from these
// conditions.
struct Work {
  uint steps;
  uint truncated;
};

void keepCloser(inout Hit hit, PrimitiveHit candidate, uint slot, uint instance) {
  bool first = candidate.index < hit.index;
  if (kHasOrdered && candidate.ordered != hit.ordered) first = hit.ordered;
  bool better = candidate.t < hit.t || (candidate.t == hit.t && first);
  hit.t = better ? candidate.t : hit.t;
  hit.slot = better ? slot : hit.slot;
  hit.index = better ? candidate.index : hit.index;
  if (kHasInstances) hit.instance = better ? instance : hit.instance;
  if (kHasOrdered) hit.ordered = better ? candidate.ordered : hit.ordered;
  if (kHasOrdered) hit.distance = better ? candidate.distance : hit.distance;
}

// Returns 0, because no component of a direction reaches 2. Compilers cannot know this: docs/driver-workarounds.md
// section 5.
uint zeroOfLane(Ray ray) { return (floatBitsToUint(ray.direction.x) >> 30) & 1u; }

void closestInRange(inout Hit hit, Ray ray, uint first, uint end, uint known, inout Work work) {
  uint slot = first + zeroOfLane(ray);
  uint cutShort = slot < end ? 1u : 0u;
  while (slot < end) {
    keepCloser(hit, hitPrimitive(ray, slot, known), slot, 0u);
    ++slot;
    cutShort = slot < end ? 1u : 0u;
    if (kMasksLanes && slot >= end) break;
  }
  work.steps += slot - first;
  work.truncated += cutShort;
}

bool anyInRange(Ray ray, uint first, uint end, RayEnd rayEnd, uint known, inout Work work) {
  uint slot = first + zeroOfLane(ray);
  bool blocked = false;
  uint cutShort = slot < end ? 1u : 0u;
  while (slot < end && !blocked) {
    blocked = occludes(ray, slot, rayEnd, known);
    ++slot;
    cutShort = slot < end && !blocked ? 1u : 0u;
    if (kMasksLanes && (slot >= end || blocked)) break;
  }
  work.steps += slot - first;
  work.truncated += cutShort;
  return blocked;
}

// Small scenes: all primitives are read from the uniform buffer and tested. Their kinds are known when the kernel is
// compiled, and compilers may unroll the loops: docs/driver-workarounds.md section 6.
uint uniformKind(uint slot) {
  uvec4 kinds = slot < 16u ? kKindsOfSlots0 : slot < 32u ? kKindsOfSlots16 : kKindsOfSlots32;
  return (kinds[(slot >> 2) & 3u] >> (8u * (slot & 3u))) & 255u;
}

uint knownOfUniformSlot(uint slot) { return slot < kFirstMarkedSlot ? kApartPrimitive : kAnyPrimitive; }

// The rules for coincident surfaces branch on records, which therefore must not be uniform.
uvec4[3] rowsOfUniformSlot(Ray ray, uint slot) {
  uint row = slot * kPrimitiveRows;
  uvec4 rows[3] = uvec4[3](slotRow(row), slotRow(row + 1u), slotRow(row + 2u));
  if (slot < kFirstMarkedSlot) return rows;
  uint zero = 0u - zeroOfLane(ray);
  return uvec4[3](rows[0] | zero, rows[1] | zero, rows[2] | zero);
}

void closestOfUniform(inout Hit hit, Ray ray, inout Work work) {
  [[unroll]] for (uint slot = 0u; slot < kUniformSlots; ++slot) {
    uvec4 rows[3] = rowsOfUniformSlot(ray, slot);
    keepCloser(hit, comparedHit(ray, slot, rows, uniformKind(slot), knownOfUniformSlot(slot)), slot, 0u);
  }
  work.steps += kUniformSlots;
}

bool anyOfUniform(Ray ray, RayEnd end, inout Work work) {
  bool blocked = false;
  [[unroll]] for (uint slot = 0u; slot < kUniformSlots; ++slot) {
    uvec4 rows[3] = rowsOfUniformSlot(ray, slot);
    blocked = blocked ||
              (slot != end.light && rowsHide(ray, slot, rows, uniformKind(slot), end, knownOfUniformSlot(slot)));
  }
  work.steps += kUniformSlots;
  return blocked;
}

// Returns the componentwise inverse. A zero component would make 0 * infinity = NaN on the face of a box, so it becomes
// 2^-100, which is too small to affect a result.
vec3 inverseDirection(vec3 direction) {
  vec3 magnitude = max(abs(direction), vec3(7.9e-31));
  return 1.0 / mix(magnitude, -magnitude, lessThan(direction, vec3(0.0)));
}

#include "bvh.glsl"
#include "wide_bvh.glsl"
#include "instances.glsl"
#include "grid.glsl"

Hit traceClosest(Ray ray, inout Work work) {
  ray = withStart(ray);
  Hit hit = Hit(kNoHit, kNoSlot, 0xffffffffu, 0u, true, kNoHit);
  if (kUniformSlots > 0u) closestOfUniform(hit, ray, work);
  else if (kStructure == kStructureBvh) closestInHierarchy(hit, ray, work);
  else if (kStructure == kStructureWideBvh) closestInWideHierarchy(hit, ray, work);
  else if (kStructure == kStructureGrid) closestInGrid(hit, ray, work);
  else closestInRange(hit, ray, 0u, constants.firstPlaneSlot, kFinitePrimitive, work);
  if (kLoopsOverPlanes) closestInRange(hit, ray, constants.firstPlaneSlot, constants.slotCount, kInfinitePlane, work);
  if (kHasInstances) closestInInstances(hit, ray, work);
  if (kHasOrdered) hit.t = hit.distance;
  return hit;
}

// Returns true if a primitive hides the light at the ray's end.
bool traceAny(Ray ray, RayEnd end, inout Work work) {
  ray = withStart(ray);
  if (kLoopsOverPlanes && anyInRange(ray, constants.firstPlaneSlot, constants.slotCount, end, kInfinitePlane, work)) {
    return true;
  }
  if (kHasInstances && anyInInstances(ray, end, work)) return true;
  if (kUniformSlots > 0u) return anyOfUniform(ray, end, work);
  if (kStructure == kStructureBvh) return anyInHierarchy(ray, end, work);
  if (kStructure == kStructureWideBvh) return anyInWideHierarchy(ray, end, work);
  if (kStructure == kStructureGrid) return anyInGrid(ray, end, work);
  return anyInRange(ray, 0u, constants.firstPlaneSlot, end, kFinitePrimitive, work);
}

#endif
