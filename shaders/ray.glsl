// Rays, with what the tests of primitives need to know about them.
#ifndef CANDELA_RAY_GLSL
#define CANDELA_RAY_GLSL
#include "math.glsl"
#include "options.glsl"
#include "shared/render_data.h"

const float kNoHit = kLargestFloat;

// A flat surface. An infinite plane has four equal points.
struct FlatSurface {
  vec3 points[4];
  vec3 normal;  // unit
  bool infinite;
};

// The shear of Woop, Benthin and Wald (JCGT 2013) along a direction.
struct Shear {
  bvec2 along;  // the direction's largest component is x, or y; else it is z
  vec3 coefficients;
};

// The origin primitive, if another one may coincide with it: coincidence.glsl.
struct RayStart {
  uvec4 rows[3];
  FlatSurface surface;  // on which the ray starts, if it is flat
  Shear shear;          // along the normal of this surface; set if triangles may coincide
};

struct Ray {
  vec3 origin;
  vec3 direction;   // unit
  uint originSlot;  // slot of the origin primitive and flags kOrigin..., or kNoSlot
  uint originInstance;  // of the origin primitive: number of the instance, or 0
  Shear shear;      // along the direction; set if the scene has triangles
  uint opacityKey;  // of the decisions which transparent triangles it hits; set if the scene has any
  RayStart start;   // set by withStart() if the scene has coincident surfaces
};

// Permutes the components cyclically so that the one that `along` names becomes z.
vec3 largestLast(vec3 v, bvec2 along) {
  vec3 w = mix(v, v.zxy, bvec3(along.y));
  return mix(w, v.yzx, bvec3(along.x));
}

Shear shearAlong(vec3 direction) {
  vec3 size = abs(direction);
  bvec2 along;
  along.x = size.x > size.y && size.x > size.z;
  along.y = !along.x && size.y > size.z;
  vec3 d = largestLast(direction, along);
  return Shear(along, vec3(-d.x / d.z, -d.y / d.z, 1.0 / d.z));
}

Ray makeRay(vec3 origin, vec3 direction, uint originSlot) {
  Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.originSlot = originSlot;
  ray.originInstance = 0u;
  ray.shear = Shear(bvec2(false), vec3(0.0));
  if (kHasTriangles) ray.shear = shearAlong(direction);
  ray.opacityKey = 0u;
  return ray;
}

// Maps `origin` to 0, and the direction of the shear to (0, 0, 1).
vec3 sheared(vec3 p, vec3 origin, Shear shear) {
  precise vec3 q = largestLast(p - origin, shear.along);
  precise vec3 result = vec3(q.xy + shear.coefficients.xy * q.z, shear.coefficients.z * q.z);
  return result;
}

// Returns whether the primitive in this slot is the ray's origin primitive.
bool startsOn(Ray ray, uint slot) { return (ray.originSlot & kOriginSlotMask) == slot; }

float positiveOrNone(float t) { return t > 0.0 ? t : kNoHit; }

#endif
