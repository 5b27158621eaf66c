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

// The origin primitive, if another one may coincide with it: coincidence.glsl.
struct RayStart {
  uvec4 rows[3];
  FlatSurface surface;  // on which the ray starts, if it is flat
};

struct Ray {
  vec3 origin;
  vec3 direction;   // unit
  uint originSlot;  // slot of the origin primitive and flags kOrigin..., or kNoSlot
  uint originInstance;  // of the origin primitive: number of the instance, or 0
  bvec2 along;      // the direction's largest component is x, or y; else it is z
  vec3 shear;       // coefficients of `sheared`; set if the scene has triangles
  uint opacityKey;  // of the decisions which transparent triangles it hits; set if the scene has any
  RayStart start;   // set by withStart() if the scene has coincident surfaces
};

// Permutes the components cyclically so that the one that `along` names becomes z.
vec3 largestLast(vec3 v, bvec2 along) {
  vec3 w = mix(v, v.zxy, bvec3(along.y));
  return mix(w, v.yzx, bvec3(along.x));
}

Ray makeRay(vec3 origin, vec3 direction, uint originSlot) {
  bvec2 along = bvec2(false);
  vec3 shear = vec3(0.0);
  if (kHasTriangles) {
    vec3 size = abs(direction);
    along.x = size.x > size.y && size.x > size.z;
    along.y = !along.x && size.y > size.z;
    vec3 d = largestLast(direction, along);
    shear = vec3(-d.x / d.z, -d.y / d.z, 1.0 / d.z);
  }
  Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.originSlot = originSlot;
  ray.originInstance = 0u;
  ray.along = along;
  ray.shear = shear;
  ray.opacityKey = 0u;
  return ray;
}

// The shear of Woop, Benthin and Wald (JCGT 2013). It maps the ray's origin to 0 and its direction to (0, 0, 1).
vec3 sheared(vec3 p, Ray ray) {
  precise vec3 q = largestLast(p - ray.origin, ray.along);
  precise vec3 result = vec3(q.xy + ray.shear.xy * q.z, ray.shear.z * q.z);
  return result;
}

// Returns whether the primitive in this slot is the ray's origin primitive.
bool startsOn(Ray ray, uint slot) { return (ray.originSlot & kOriginSlotMask) == slot; }

float positiveOrNone(float t) { return t > 0.0 ? t : kNoHit; }

#endif
