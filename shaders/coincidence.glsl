// Surfaces that coincide with the one on which a ray starts: docs/light-transport.md section 4. Only primitives that
// the host has marked (kFlagCoincident) can; a scene without any compiles nothing of this file.
#ifndef CANDELA_COINCIDENCE_GLSL
#define CANDELA_COINCIDENCE_GLSL
#include "geometry.glsl"
#include "placements.glsl"
#include "scene_access.glsl"

const float kAtOnce = 1e-37;              // distance of a hit on a surface that coincides with the origin's
const float kCoplanar = 1.0 / 2097152.0;  // tolerance as a fraction of the largest coordinate

FlatSurface flatTriangle(vec3 p0, vec3 p1, vec3 p2) {
  return FlatSurface(vec3[4](p0, p1, p2, p2), triangleNormal(p1 - p0, p2 - p0), false);
}

FlatSurface flatPlane(vec3 point, vec3 normal) {
  return FlatSurface(vec3[4](point, point, point, point), normal, true);
}

// The face of a box on the lower or the upper side of an axis.
FlatSurface flatFace(vec3 low, vec3 high, int axis, bool upper) {
  bvec3 across = bvec3(axis == 0, axis == 1, axis == 2);
  vec3 from = mix(low, upper ? high : low, across);
  vec3 to = mix(high, from, across);
  bvec3 first = bvec3(axis == 1, axis == 2, axis == 0);
  return FlatSurface(vec3[4](from, mix(from, to, first), mix(to, from, first), to), vec3(across), false);
}

// Returns whether the points of a surface are this close to the plane of another one.
bool isWithin(FlatSurface surface, FlatSurface plane, float tolerance) {
  float deepest = 0.0;
  [[unroll]] for (int i = 0; i < 4; ++i) {
    precise float depth = dot(surface.points[i] - plane.points[0], plane.normal);
    deepest = larger(deepest, abs(depth));
  }
  return deepest <= tolerance;
}

float largestCoordinate(FlatSurface surface) {
  float reach = 0.0;
  [[unroll]] for (int i = 0; i < 4; ++i) reach = larger(reach, largest(abs(surface.points[i])));
  return reach;
}

bool areCoplanar(FlatSurface a, FlatSurface b) {
  float tolerance = kCoplanar * larger(largestCoordinate(a), largestCoordinate(b));
  bool aInB = isWithin(a, b, tolerance);
  bool bInA = isWithin(b, a, tolerance);
  if (a.infinite && b.infinite) return bInA && largest(abs(cross(a.normal, b.normal))) <= kCoplanar;
  return aInB && !a.infinite || bInA && !b.infinite;
}

// Returns the flat surface of a triangle or plane, or the face of a box that is closest to a point on it.
FlatSurface flatSurfaceOf(uvec4 rows[3], vec3 point) {
  vec3 row0 = uintBitsToFloat(rows[0].xyz);
  vec3 row1 = uintBitsToFloat(rows[1].xyz);
  if (kPlanesCoincide && isKind(rows[2].w, kKindPlane)) return flatPlane(row0, row1);
  if (kBoxesCoincide && isKind(rows[2].w, kKindBox)) {
    vec3 toLow = abs(point - row0);
    vec3 toHigh = abs(point - row1);
    vec3 nearer = min(toLow, toHigh);
    int axis = nearer.x <= nearer.y && nearer.x <= nearer.z ? 0 : nearer.y <= nearer.z ? 1 : 2;
    return flatFace(row0, row1, axis, toHigh[axis] < toLow[axis]);
  }
  return flatTriangle(row0, row1, uintBitsToFloat(rows[2].xyz));
}

// Returns the records of the ray's origin primitive, which the host has marked. In a list, few are marked, and choosing
// among their uniform records is cheaper than reading records that differ in each lane.
uvec4[3] rowsOfStart(Ray ray) {
  if (kUniformSlots == 0u) return placedRowsOf(ray.originSlot & kOriginSlotMask, ray.originInstance);
  uint first = kFirstMarkedSlot * kPrimitiveRows;
  uvec4 rows[3] = uvec4[3](slotRow(first), slotRow(first + 1u), slotRow(first + 2u));
  [[unroll]] for (uint slot = kFirstMarkedSlot + 1u; slot < kUniformSlots; ++slot) {
    bvec4 here = bvec4(startsOn(ray, slot));
    [[unroll]] for (uint i = 0u; i < kPrimitiveRows; ++i) {
      rows[i] = mix(rows[i], slotRow(slot * kPrimitiveRows + i), here);
    }
  }
  return rows;
}

// Returns the ray with what the rules need to know about its origin primitive.
Ray startedRay(Ray ray) {
  ray.start.rows = rowsOfStart(ray);
  ray.start.surface = flatSurfaceOf(ray.start.rows, ray.origin);
  if (kTrianglesCoincide) ray.start.shear = shearAlong(ray.start.surface.normal);
  return ray;
}

// Lanes of a processor read the origin primitive once for each ray. GPUs read it when a rule needs it.
Ray withStart(Ray ray) {
  if (!kMasksLanes || !kHasCoincident || (ray.originSlot & kOriginCoincident) == 0u) return ray;
  return startedRay(ray);
}

bool isFlat(uint kind) { return !isKind(kind, kKindSphere) && !isKind(kind, kKindCone); }

// Returns whether the rules apply to the test of a primitive with these records.
bool followsRules(Ray ray, uvec4 rows[3], bool startsHere) {
  return !startsHere && (ray.originSlot & kOriginCoincident) != 0u && (rows[2].w & kFlagCoincident) != 0u;
}

bool coincidesWithStart(Ray ray, FlatSurface surface) {
  return isFlat(ray.start.rows[2].w) && areCoplanar(ray.start.surface, surface);
}

// Returns whether two primitives are the same sphere, cone or box. Only the sign of a sphere's radius may differ.
bool areSameBody(uvec4 a[3], uvec4 b[3]) {
  if (((a[2].w ^ b[2].w) & kKindMask) != 0u) return false;
  bool sameTop = a[0] == b[0] && a[1].xyz == b[1].xyz;
  return sameTop && (!isKind(a[2].w, kKindCone) || a[2].x == b[2].x);
}

bool isInward(Ray ray) { return (ray.originSlot & kOriginInward) != 0u; }

// Returns the place of a surface in the order in a plane, apart from its emission, for a ray that enters or exits it.
uint placeInPlane(uint kind, bool enters) {
  if ((kind & kFlagTransmits) == 0u) return 3u;
  if ((kind & kFlagThinWalled) != 0u) return 2u;
  return enters && isFlat(kind) ? 4u : 1u;
}

// Returns whether the ray passes a primitive that coincides with its origin primitive. `sameSide`: it enters both of
// them, or exits both.
bool passes(Ray ray, uvec4 rows[3], bool sameSide) {
  if (!kLightCrossesCoincident) return true;
  bool transmits = (rows[2].w & kFlagTransmits) != 0u;
  uint contact = ray.originSlot & (kOriginBeyond | kOriginBack);
  bool crosses = (ray.originSlot & kOriginCrosses) != 0u;
  // A ray that stays on its side goes back, and hits what came first for the ray that arrived.
  bool entersOrigin = isInward(ray) == crosses;
  uint here = placeInPlane(ray.start.rows[2].w, entersOrigin);
  uint there = placeInPlane(rows[2].w, entersOrigin == sameSide);
  bool isThereFirst = there < here || there == here && indexOf(rows) < indexOf(ray.start.rows);
  bool isSame = rows[2].w >> kMaterialShift == ray.start.rows[2].w >> kMaterialShift;
  bool isContinued = isSame && (sameSide || (rows[2].w & kFlagThinWalled) != 0u);
  if (transmits) return isContinued || (crosses ? isThereFirst : contact == 0u || !isThereFirst);
  return crosses ? isThereFirst || contact == kOriginBack : contact != kOriginBack;
}

// Returns whether the ray hits at once a sphere that is its origin primitive apart from the radius' sign.
bool hitsSphereAtOnce(Ray ray, uvec4 rows[3]) {
  bool insideOnly = kHasInsideOnly && (rows[2].w & kFlagInsideOnly) != 0u;
  bool flipped = kHasInsideOnly && ((rows[2].w ^ ray.start.rows[2].w) & kFlagInsideOnly) != 0u;
  bool enters = isInward(ray) != (kHasInsideOnly && (ray.start.rows[2].w & kFlagInsideOnly) != 0u);
  return !passes(ray, rows, !flipped) && !(insideOnly && enters);
}

// Returns the cosine of the ray's angle to the outward normal of a flat primitive, which the ray hits at distance t.
float flatCosine(Ray ray, uvec4 rows[3], float t) {
  vec3 row0 = uintBitsToFloat(rows[0].xyz);
  vec3 row1 = uintBitsToFloat(rows[1].xyz);
  if (kHasPlanes && isKind(rows[2].w, kKindPlane)) return dot(row1, ray.direction);
  if (kHasBoxes && isKind(rows[2].w, kKindBox)) {
    vec3 position = ray.origin + t * ray.direction;
    return dot(boxNormal(ray, row0, row1, t, false, position), ray.direction);
  }
  return dot(triangleNormal(row1 - row0, uintBitsToFloat(rows[2].xyz) - row0), ray.direction);
}

// Returns the distance that an ordered primitive counts for, in comparisons with others that the ray hits.
float orderedDistance(Ray ray, uvec4 rows[3], float t) {
  if (!isFlat(rows[2].w)) return t;
  float cosine = flatCosine(ray, rows, t);
  float place = float(placeInPlane(rows[2].w, cosine < 0.0));
  if (t == kAtOnce) return (1.0 + place) * kAtOnce;
  float margin = place * 2.0 * kCoplanar * larger(uintBitsToFloat(kOrderReach), largest(abs(ray.origin)));
  return min(t + margin / abs(cosine), 0.5 * kNoHit);
}

// Returns the distance to a flat primitive in the plane of the ray's origin, which the line through the origin along the
// normal of this plane meets. (That of the ray may meet the primitive anywhere if it lies almost in the plane.)
float hitInPlane(Ray ray, uvec4 rows[3], vec3 normal) {
  return passes(ray, rows, dot(normal, ray.direction) < 0.0 == isInward(ray)) ? kNoHit : kAtOnce;
}

// Returns whether a ray through a box can start on the face through which it exits, rather than on that through which it
// enters. If the faces are too close to tell, it can.
bool mayStartOnExit(Ray ray, vec3 low, vec3 high, int entryAxis, int exitAxis, float entry, float exit) {
  vec3 normal = abs(ray.start.surface.normal);
  if (entryAxis != exitAxis) return normal[exitAxis] > normal[entryAxis];
  float reach = larger(largestCoordinate(ray.start.surface), largest(max(abs(low), abs(high))));
  return abs(exit) <= abs(entry) || high[exitAxis] - low[exitAxis] <= kCoplanar * reach;
}

// Returns the distance to a box. If the rules apply (`ruled`), it may be the origin primitive's copy, or one of its
// faces may lie in the plane of the ray's origin.
float hitBoxByRules(Ray ray, uvec4 rows[3], bool startsHere, bool ruled) {
  vec3 low = uintBitsToFloat(rows[0].xyz);
  vec3 high = uintBitsToFloat(rows[1].xyz);
  vec3 near, far;
  boxSlabs(ray, low, high, near, far);
  float entry = largest(near);
  float exit = min(far.x, min(far.y, far.z));
  if (entry > exit) return kNoHit;
  bool same = ruled && areSameBody(ray.start.rows, rows);
  if (same && !passes(ray, rows, true)) return kAtOnce;
  if (startsHere || same) return isInward(ray) ? positiveOrNone(exit) : kNoHit;
  int exitAxis = far.x <= far.y && far.x <= far.z ? 0 : far.y <= far.z ? 1 : 2;
  int entryAxis = near.x >= near.y && near.x >= near.z ? 0 : near.y >= near.z ? 1 : 2;
  bool onExit = mayStartOnExit(ray, low, high, entryAxis, exitAxis, entry, exit);
  int axis = onExit ? exitAxis : entryAxis;
  if (ruled && coincidesWithStart(ray, flatFace(low, high, axis, ray.direction[axis] > 0.0 == onExit))) {
    bvec3 beside = greaterThan(abs(ray.origin - 0.5 * (low + high)), 0.5 * (high - low));
    beside[axis] = false;
    if (!any(beside) && !passes(ray, rows, onExit != isInward(ray))) return kAtOnce;
    return onExit ? kNoHit : positiveOrNone(exit);
  }
  return entry > 0.0 ? entry : positiveOrNone(exit);
}

// Returns whether two emitters, which are spheres or triangles, coincide.
bool emittersCoincide(uvec4 a[3], uvec4 b[3]) {
  if (((a[2].w ^ b[2].w) & kKindMask) != 0u) return false;
  if (isKind(a[2].w, kKindSphere)) return areSameBody(a, b);
  return isKind(a[2].w, kKindTriangle) && areCoplanar(flatSurfaceOf(a, vec3(0.0)), flatSurfaceOf(b, vec3(0.0)));
}

#endif
