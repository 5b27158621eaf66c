// Surfaces that coincide with the one on which a ray starts: docs/light-transport.md section 4. Only primitives that the
// host has marked (kFlagCoincident) can; a scene without any compiles nothing of this file.
#ifndef CANDELA_COINCIDENCE_GLSL
#define CANDELA_COINCIDENCE_GLSL
#include "geometry.glsl"
#include "scene_access.glsl"

const float kAtOnce = 1e-37;  // distance of a hit on a surface that coincides with the origin's
const float kCoplanar = 1.0 / 2097152.0;  // tolerance as a fraction of the largest coordinate

// A flat surface. An infinite plane has four equal points.
struct FlatSurface {
  vec3 points[4];
  vec3 normal;  // unit
  bool infinite;
};

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

bool isCurved(uint kind) { return isKind(kind, kKindSphere) || isKind(kind, kKindCone); }

// Returns whether two primitives are the same sphere, cone or box. Only the sign of a sphere's radius may differ.
bool areSameBody(uvec4 a[3], uvec4 b[3]) {
  if (((a[2].w ^ b[2].w) & kKindMask) != 0u || isKind(a[2].w, kKindTriangle) || isKind(a[2].w, kKindPlane)) return false;
  bool sameTop = a[0] == b[0] && a[1].xyz == b[1].xyz;
  return sameTop && (!isKind(a[2].w, kKindCone) || a[2].x == b[2].x);
}

// Returns the flat surface of a triangle or plane, or the face of a box that is closest to a point on it.
FlatSurface flatSurfaceOf(uvec4 rows[3], vec3 point) {
  vec3 row0 = uintBitsToFloat(rows[0].xyz);
  vec3 row1 = uintBitsToFloat(rows[1].xyz);
  if (kHasPlanes && isKind(rows[2].w, kKindPlane)) return flatPlane(row0, row1);
  if (kHasBoxes && isKind(rows[2].w, kKindBox)) {
    vec3 toLow = abs(point - row0);
    vec3 toHigh = abs(point - row1);
    vec3 nearer = min(toLow, toHigh);
    int axis = nearer.x <= nearer.y && nearer.x <= nearer.z ? 0 : nearer.y <= nearer.z ? 1 : 2;
    return flatFace(row0, row1, axis, toHigh[axis] < toLow[axis]);
  }
  return flatTriangle(row0, row1, uintBitsToFloat(rows[2].xyz));
}

// A primitive on which a ray starts, and whether the ray passes another one that coincides with it.
struct RayStart {
  uvec4 rows[3];
  bool inward;
  bool passesSameSide;   // if it enters both or exits both
  bool passesOtherSide;
};

RayStart startOf(Ray ray, uvec4 origin[3], uvec4 rows[3]) {
  bool transmits = (rows[2].w & kFlagTransmits) != 0u;
  bool isContinued = transmits && rows[2].w >> kMaterialShift == origin[2].w >> kMaterialShift;
  RayStart start = RayStart(origin, (ray.originSlot & kOriginInward) != 0u, true, true);
  uint contact = ray.originSlot & (kOriginBeyond | kOriginBack);
  bool crosses = (ray.originSlot & kOriginCrosses) != 0u;
  if (crosses && contact != kOriginBack) {
    bool isBehind = transmits && rows[1].w < origin[1].w;
    start.passesSameSide = isBehind || isContinued;
    start.passesOtherSide = isBehind || isContinued && (rows[2].w & kFlagThinWalled) != 0u;
  }
  if (!crosses && contact != 0u) {
    start.passesSameSide = isContinued || contact == kOriginBeyond && !transmits;
    start.passesOtherSide = start.passesSameSide;
  }
  return start;
}

bool passes(RayStart start, bool inward) { return inward == start.inward ? start.passesSameSide : start.passesOtherSide; }

// Returns the distance to a sphere, cone or box that is the same body as the origin primitive.
float hitSameBody(Ray ray, uvec4 rows[3], RayStart start) {
  vec4 row0 = uintBitsToFloat(rows[0]);
  vec3 row1 = uintBitsToFloat(rows[1].xyz);
  if (kHasSpheres && isKind(rows[2].w, kKindSphere)) {
    bool insideOnly = kHasInsideOnly && (rows[2].w & kFlagInsideOnly) != 0u;
    bool flipped = kHasInsideOnly && ((rows[2].w ^ start.rows[2].w) & kFlagInsideOnly) != 0u;
    bool enters = start.inward != ((start.rows[2].w & kFlagInsideOnly) != 0u);
    if (!(flipped ? start.passesOtherSide : start.passesSameSide) && !(insideOnly && enters)) return kAtOnce;
    return hitSphere(ray, row0.xyz, row0.w, row1, insideOnly, true);
  }
  if (!start.passesSameSide) return kAtOnce;
  if (kHasBoxes && isKind(rows[2].w, kKindBox)) return hitBox(ray, row0.xyz, row1, true, start.inward);
  if (kHasCones) return hitCone(ray, row0.xyz, row0.w, row1, uintBitsToFloat(rows[2].x), true);
  return kNoHit;
}

// Returns the distance to a box, of which a face may lie in the plane of the ray's origin.
float hitBoxInPlane(Ray ray, vec3 low, vec3 high, FlatSurface plane, RayStart start) {
  vec3 near, far;
  boxSlabs(ray, low, high, near, far);
  float entry = largest(near);
  float exit = min(far.x, min(far.y, far.z));
  if (entry > exit) return kNoHit;
  int exitAxis = far.x <= far.y && far.x <= far.z ? 0 : far.y <= far.z ? 1 : 2;
  if (areCoplanar(plane, flatFace(low, high, exitAxis, ray.direction[exitAxis] > 0.0))) {
    return passes(start, false) ? kNoHit : kAtOnce;
  }
  int entryAxis = near.x >= near.y && near.x >= near.z ? 0 : near.y >= near.z ? 1 : 2;
  if (areCoplanar(plane, flatFace(low, high, entryAxis, ray.direction[entryAxis] < 0.0))) {
    return passes(start, true) ? positiveOrNone(exit) : kAtOnce;
  }
  return entry > 0.0 ? entry : positiveOrNone(exit);
}

// Returns the distance to a triangle or a plane, which may lie in the plane of the ray's origin. `t` is the distance
// along the line of the ray, or kNoHit.
float hitFlatInPlane(Ray ray, float t, FlatSurface surface, FlatSurface plane, RayStart start) {
  if (t >= kNoHit || !areCoplanar(plane, surface)) return positiveOrNone(t);
  return passes(start, dot(surface.normal, ray.direction) < 0.0) ? kNoHit : kAtOnce;
}

// Returns the distance to a flat primitive or a box of a ray that starts on another one.
float hitInPlane(Ray ray, uvec4 rows[3], uvec4 origin[3], RayStart start) {
  vec3 row0 = uintBitsToFloat(rows[0].xyz);
  vec3 row1 = uintBitsToFloat(rows[1].xyz);
  uint kind = rows[2].w;
  FlatSurface plane = flatSurfaceOf(origin, ray.origin);
  if (kHasTriangles && isKind(kind, kKindTriangle)) {
    vec3 row2 = uintBitsToFloat(rows[2].xyz);
    return hitFlatInPlane(ray, triangleDistance(ray, row0, row1, row2), flatTriangle(row0, row1, row2), plane, start);
  }
  if (kHasBoxes && isKind(kind, kKindBox)) return hitBoxInPlane(ray, row0, row1, plane, start);
  if (!kHasPlanes) return kNoHit;
  return hitFlatInPlane(ray, planeDistance(ray, row0, row1), flatPlane(row0, row1), plane, start);
}

// Returns whether two emitters, which are spheres or triangles, coincide.
bool emittersCoincide(uvec4 a[3], uvec4 b[3]) {
  if (((a[2].w ^ b[2].w) & kKindMask) != 0u) return false;
  if (isKind(a[2].w, kKindSphere)) return areSameBody(a, b);
  return isKind(a[2].w, kKindTriangle) && areCoplanar(flatSurfaceOf(a, vec3(0.0)), flatSurfaceOf(b, vec3(0.0)));
}

#endif
