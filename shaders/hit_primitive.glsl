// The intersection test of the primitive of a slot, whatever its kind, which all traversals share.
#ifndef CANDELA_HIT_PRIMITIVE_GLSL
#define CANDELA_HIT_PRIMITIVE_GLSL
#include "attributes.glsl"
#include "coincidence.glsl"
#include "geometry.glsl"
#include "opacity.glsl"
#include "scene_access.glsl"

struct PrimitiveHit {
  float t;
  uint index;  // primitive index in the scene
};

float hitDistance(Ray ray, uvec4 rows[3], uint kind, bool startsHere, bool inward) {
  vec4 row0 = uintBitsToFloat(rows[0]);
  vec4 row1 = uintBitsToFloat(rows[1]);
  vec4 row2 = uintBitsToFloat(rows[2]);
  if (kHasSpheres && isKind(kind, kKindSphere)) {
    bool insideOnly = kHasInsideOnly && (kind & kFlagInsideOnly) != 0u;
    return hitSphere(ray, row0.xyz, row0.w, row1.xyz, insideOnly, startsHere);
  }
  if (kHasTriangles && isKind(kind, kKindTriangle)) {
    return startsHere ? kNoHit : hitTriangle(ray, row0.xyz, row1.xyz, row2.xyz);
  }
  if (kHasBoxes && isKind(kind, kKindBox)) return hitBox(ray, row0.xyz, row1.xyz, startsHere, inward);
  if (kHasCones && isKind(kind, kKindCone)) {
    return hitCone(ray, row0.xyz, row0.w, row1.xyz, row2.x, startsHere);
  }
  if (kHasPlanes && isKind(kind, kKindPlane)) return startsHere ? kNoHit : hitPlane(ray, row0.xyz, row1.xyz);
  return kNoHit;
}

// Returns whether --one-sided lets the ray pass: it hits the back of an opaque triangle or plane.
bool isDroppedBack(Ray ray, uvec4 rows[3], uint kind) {
  if (!kOneSided || (kind & kFlagOpaque) == 0u) return false;
  vec3 p0 = uintBitsToFloat(rows[0].xyz);
  vec3 p1 = uintBitsToFloat(rows[1].xyz);
  if (isKind(kind, kKindPlane)) return dot(p1, ray.direction) > 0.0;
  if (!isKind(kind, kKindTriangle)) return false;
  vec3 p2 = uintBitsToFloat(rows[2].xyz);
  return dot(cross(p1 - p0, p2 - p0), ray.direction) > 0.0;
}

// Returns the distance to the primitive of a slot with these records, whatever its opacity.
float distanceToRows(Ray ray, uint slot, uvec4 rows[3], uint kind) {
  bool startsHere = startsOn(ray, slot);
  if (kHasCoincident && !startsHere && (ray.originSlot & kOriginCoincident) != 0u &&
      (rows[2].w & kFlagCoincident) != 0u) {
    uvec4 origin[3] = rowsOfSlot(ray.originSlot & kOriginSlotMask);
    RayStart start = startOf(ray, origin, rows);
    if ((kHasSpheres || kHasCones || kHasBoxes) && areSameBody(rows, origin)) return hitSameBody(ray, rows, start);
    if (!isCurved(rows[2].w) && !isCurved(origin[2].w)) return hitInPlane(ray, rows, origin, start);
  }
  return hitDistance(ray, rows, kind, startsHere, (ray.originSlot & kOriginInward) != 0u);
}

PrimitiveHit hitRows(Ray ray, uint slot, uvec4 rows[3], uint kind) {
  float t = distanceToRows(ray, slot, rows, kind);
  if (isDroppedBack(ray, rows, kind)) t = kNoHit;
  if (kHasTransparency && t < kNoHit && (kind & kFlagTransparent) != 0u && !isThere(ray, rows, t)) t = kNoHit;
  return PrimitiveHit(t, rows[1].w);
}

PrimitiveHit hitPrimitive(Ray ray, uint slot) {
  uvec4 rows[3] = rowsOfSlot(slot);
  return hitRows(ray, slot, rows, rows[2].w);
}

#endif
