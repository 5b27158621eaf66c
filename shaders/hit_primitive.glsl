// The intersection test of the primitive of a slot, whatever its kind, which all traversals share.
#ifndef CANDELA_HIT_PRIMITIVE_GLSL
#define CANDELA_HIT_PRIMITIVE_GLSL
#include "attributes.glsl"
#include "coincidence.glsl"
#include "geometry.glsl"
#include "opacity.glsl"
#include "scene_access.glsl"

// The closest hit of a ray.
struct Hit {
  float t;  // kNoHit: no hit, and the other members are undefined; during the search, the distance that is compared
  uint slot;
  uint index;  // primitive index; at equal distances ordered ones come last, then the higher indices
  uint instance;  // number of the instance, or 0
  bool ordered;    // kFlagOrdered; undefined without kHasOrdered, as the next member
  float distance;  // of the hit itself
};

struct PrimitiveHit {
  float t;
  uint index;  // primitive index in the scene
  bool ordered;
  float distance;  // before the order in a plane changes t
};

// Callers state what they know of the primitive, so that less code is compiled.
const uint kAnyPrimitive = 0u;
const uint kFinitePrimitive = 1u;
const uint kInfinitePlane = 2u;
const uint kApartPrimitive = 3u;  // it coincides with no other
const uint kSphere = 4u;

// Returns the distance to the primitive of a slot with these records, whatever its opacity. `known` is a constant.
float distanceToRows(Ray ray, uint slot, uvec4 rows[3], uint kind, uint known) {
  vec4 row0 = uintBitsToFloat(rows[0]);
  vec4 row1 = uintBitsToFloat(rows[1]);
  vec4 row2 = uintBitsToFloat(rows[2]);
  bool startsHere = startsOn(ray, slot);
  bool ruled = kHasCoincident && known != kApartPrimitive && followsRules(ray, rows, startsHere);
  if (!kMasksLanes && ruled) ray = startedRay(ray);
  bool mayBePlane = known != kFinitePrimitive && known != kSphere;
  if (kHasPlanes && mayBePlane && (known == kInfinitePlane || isKind(kind, kKindPlane))) {
    if (startsHere) return kNoHit;
    bool inPlane = kPlanesCoincide && ruled && coincidesWithStart(ray, flatPlane(row0.xyz, row1.xyz));
    if (inPlane) return hitInPlane(ray, rows, row1.xyz);
    return positiveOrNone(planeDistance(ray, row0.xyz, row1.xyz));
  }
  if (known == kInfinitePlane) return kNoHit;
  if (kHasSpheres && (known == kSphere || isKind(kind, kKindSphere))) {
    bool insideOnly = kHasInsideOnly && (kind & kFlagInsideOnly) != 0u;
    bool same = kSpheresCoincide && ruled && areSameBody(ray.start.rows, rows);
    if (same && hitsSphereAtOnce(ray, rows)) return kAtOnce;
    return hitSphere(ray, row0.xyz, row0.w, row1.xyz, insideOnly, startsHere || same);
  }
  if (known == kSphere) return kNoHit;
  if (kHasTriangles && isKind(kind, kKindTriangle)) {
    if (startsHere) return kNoHit;
    FlatSurface surface = flatTriangle(row0.xyz, row1.xyz, row2.xyz);
    bool inPlane = kTrianglesCoincide && ruled && coincidesWithStart(ray, surface);
    Shear shear = ray.shear;
    if (kTrianglesCoincide) {
      shear.along = mix(shear.along, ray.start.shear.along, bvec2(inPlane));
      shear.coefficients = mix(shear.coefficients, ray.start.shear.coefficients, bvec3(inPlane));
    }
    bool coincides = kTrianglesCoincide && (rows[2].w & kFlagCoincident) != 0u;
    float t = triangleDistance(ray.origin, shear, inPlane, coincides, row0.xyz, row1.xyz, row2.xyz);
    return inPlane && t < kNoHit ? hitInPlane(ray, rows, surface.normal) : t;
  }
  if (kHasBoxes && isKind(kind, kKindBox)) {
    if (kBoxesCoincide && known != kApartPrimitive) return hitBoxByRules(ray, rows, startsHere, ruled);
    return hitBox(ray, row0.xyz, row1.xyz, startsHere, isInward(ray));
  }
  if (kHasCones && isKind(kind, kKindCone)) {
    bool same = kConesCoincide && ruled && areSameBody(ray.start.rows, rows);
    if (same && !passes(ray, rows, true)) return kAtOnce;
    return hitCone(ray, row0.xyz, row0.w, row1.xyz, row2.x, startsHere || same);
  }
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

PrimitiveHit hitRows(Ray ray, uint slot, uvec4 rows[3], uint kind, uint known) {
  float t = distanceToRows(ray, slot, rows, kind, known);
  if (isDroppedBack(ray, rows, kind)) t = kNoHit;
  if (kHasTransparency && t < kNoHit && (kind & kFlagTransparent) != 0u && !isThere(ray, slot, rows, t)) t = kNoHit;
  return PrimitiveHit(t, indexOf(rows), kHasOrdered && (rows[2].w & kFlagOrdered) != 0u, t);
}

// Returns the hit as it is compared with others.
PrimitiveHit comparedHit(Ray ray, uint slot, uvec4 rows[3], uint kind, uint known) {
  PrimitiveHit hit = hitRows(ray, slot, rows, kind, known);
  if (!kHasOrdered || known == kApartPrimitive || hit.t >= kNoHit || !hit.ordered) return hit;
  hit.t = orderedDistance(ray, rows, hit.t);
  return hit;
}

PrimitiveHit hitPrimitive(Ray ray, uint slot, uint known) {
  uvec4 rows[3] = rowsOfSlot(slot);
  return comparedHit(ray, slot, rows, rows[2].w, known);
}

#endif
