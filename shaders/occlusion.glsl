// Decides what hides a light from a shadow ray: docs/light-transport.md section 6. Surfaces that contain the light
// within a margin do not. Of emitters that coincide, a ray sees the one whose distance is smaller, or the lower index.
// Only primitives that the host has marked (kFlagTouched) can contain one; a scene without any compiles this file to a
// comparison of distances.
#ifndef CANDELA_OCCLUSION_GLSL
#define CANDELA_OCCLUSION_GLSL
#include "primitives.glsl"

// The end of a shadow ray.
struct RayEnd {
  float distance;  // hits from here on do not occlude
  uint light;      // slot of the light's own primitive, which does not occlude it; kNoSlot: it has none
  vec3 point;      // the point of the light; kNoPoint: surfaces hide the light even if it touches them
};

const vec3 kNoPoint = vec3(kNoHit);
const float kLightMargin = 1.0 / 524288.0;  // as a fraction of the largest coordinate

float lightMargin(vec3 point, float reach) { return kLightMargin * larger(largest(abs(point)), reach); }

// Tests a surface through a point at `offset` from the light. `normal` is a unit vector.
bool isInPlane(vec3 offset, vec3 normal, float margin) {
  precise float depth = dot(offset, normal);
  return abs(depth) <= margin * dot(abs(normal), vec3(1.0));
}

bool triangleContains(vec3 p0, vec3 p1, vec3 p2, vec3 point) {
  float reach = larger(largest(abs(p0)), larger(largest(abs(p1)), largest(abs(p2))));
  return isInPlane(point - p0, triangleNormal(p1 - p0, p2 - p0), lightMargin(point, reach));
}

// Tests the face that the ray hits.
bool boxContains(Ray ray, vec3 low, vec3 high, float t, bool startsHere, vec3 point) {
  vec3 onFace = point;
  vec3 normal = boxNormal(ray, low, high, t, startsHere, onFace);
  return isInPlane(point - onFace, normal, lightMargin(point, largest(max(abs(low), abs(high)))));
}

// Returns whether the hit at t is the end at the light of a chord, whose half is halfChord / scale long.
bool isEndAtLight(RayEnd end, float t, float halfChord, float scale) {
  bool ahead = halfChord * scale > 0.0;
  return !ahead || (end.distance - t) * abs(scale) <= abs(halfChord);
}

// Tests a sphere that is given as in hitSphere().
bool sphereContains(Ray ray, vec3 anchor, float radius, vec3 k, RayEnd end, float t) {
  vec3 a = end.point - anchor;
  precise float off = dot(a, a) + 2.0 * radius * dot(a, k);
  if (abs(off) > 2.0 * radius * lightMargin(end.point, largest(abs(anchor)))) return false;
  return isEndAtLight(end, t, dot(a, ray.direction) + radius * dot(k, ray.direction), 1.0);
}

bool coneContains(Ray ray, vec3 base, float baseRadius, vec3 apex, float apexRadius, RayEnd end, float t) {
  ConeFrame cone = coneFrame(base, baseRadius, apex, apexRadius);
  vec3 fromBase = end.point - base;
  precise float z = dot(fromBase, cone.axis);
  precise vec3 across = fromBase - z * cone.axis;
  precise float rho = baseRadius + cone.slope * z;
  precise float off = sqrt(dot(across, across)) - rho;
  float reach = larger(largest(abs(base)) + baseRadius, largest(abs(apex)) + apexRadius);
  if (abs(off) > lightMargin(end.point, reach) * sqrt(1.0 + cone.slope * cone.slope)) return false;
  float dz = dot(ray.direction, cone.axis);
  vec3 dAcross = ray.direction - dz * cone.axis;
  float dRho = cone.slope * dz;
  return isEndAtLight(end, t, dot(across, dAcross) - dRho * rho, dot(dAcross, dAcross) - dRho * dRho);
}

// Returns whether the primitive, which the ray hits at distance t before its end, contains the light.
bool containsLight(Ray ray, uvec4 rows[3], uint kind, bool startsHere, RayEnd end, float t, uint known) {
  if (!kHasTouched || (kind & kFlagTouched) == 0u || end.point.x >= kNoHit) return false;
  vec4 row0 = uintBitsToFloat(rows[0]);
  vec4 row1 = uintBitsToFloat(rows[1]);
  vec3 row2 = uintBitsToFloat(rows[2].xyz);
  if (kHasPlanes && known != kFinitePrimitive && (known == kInfinitePlane || isKind(kind, kKindPlane))) {
    return isInPlane(end.point - row0.xyz, row1.xyz, lightMargin(end.point, largest(abs(row0.xyz))));
  }
  if (known == kInfinitePlane) return false;
  if (kHasSpheres && isKind(kind, kKindSphere)) return sphereContains(ray, row0.xyz, row0.w, row1.xyz, end, t);
  if (kHasTriangles && isKind(kind, kKindTriangle)) return triangleContains(row0.xyz, row1.xyz, row2, end.point);
  if (kHasBoxes && isKind(kind, kKindBox)) return boxContains(ray, row0.xyz, row1.xyz, t, startsHere, end.point);
  if (kHasCones && isKind(kind, kKindCone)) return coneContains(ray, row0.xyz, row0.w, row1.xyz, row2.x, end, t);
  return false;
}

// Returns whether a primitive of this kind and material emits.
bool emits(uint kind) {
  uint row = constants.firstMaterialRow + (kind >> kMaterialShift) * kMaterialRows;
  return largest(sceneRowFloat(row + 2u).xyz) > 0.0;
}

// Returns whether a primitive other than the light, with these records, hides the light at the ray's end.
bool rowsHide(Ray ray, uint slot, uvec4 rows[3], uint kind, RayEnd end, uint known) {
  float t = hitRows(ray, slot, rows, kind, known).t;
  if (kEmittersCoincide && kHasSampledEmitters && (rows[2].w & kFlagCoincident) != 0u &&
      end.light != kNoSlot) {
    uvec4 light[3] = rowsOfSlot(end.light);
    if (emits(rows[2].w) && emittersCoincide(rows, light)) {
      float ofLight = distanceToRows(ray, end.light, light, light[2].w, kFinitePrimitive);
      return t < ofLight || (t == ofLight && t < kNoHit && rows[1].w < light[1].w);
    }
  }
  return t < end.distance && !containsLight(ray, rows, kind, startsOn(ray, slot), end, t, known);
}

bool primitiveHides(Ray ray, uint slot, RayEnd end, uint known) {
  uvec4 rows[3] = rowsOfSlot(slot);
  return rowsHide(ray, slot, rows, rows[2].w, end, known);
}

bool occludes(Ray ray, uint slot, RayEnd end, uint known) {
  return slot != end.light && primitiveHides(ray, slot, end, known);
}

#endif
