// The primitive of a slot, whatever its kind: its intersection test, the surface point that shading needs, and the rays
// that are spawned there.
#ifndef CANDELA_PRIMITIVES_GLSL
#define CANDELA_PRIMITIVES_GLSL
#include "hit_primitive.glsl"
#include "surface_point.glsl"

// Origin of a ray that leaves a surface in a direction.
vec3 spawnOrigin(Surface surface, vec3 direction) {
  if (!kHasFlat || !surface.flatSurface) return surface.position;
  return offsetAlong(surface.position, surface.outward, direction);
}

// `crosses`: the ray crosses the surface.
uint spawnSlot(Surface surface, vec3 direction, bool crosses) {
  uint slot = surface.slot | (dot(surface.outward, direction) < 0.0 ? kOriginInward : 0u);
  if (!kHasCoincident || (surface.kind & kFlagCoincident) == 0u) return slot;
  return slot | kOriginCoincident | surface.contact | (crosses ? kOriginCrosses : 0u);
}

// Spawns a ray from a surface.
Ray rayFrom(Surface surface, vec3 direction, bool crosses) {
  Ray ray = makeRay(spawnOrigin(surface, direction), direction, spawnSlot(surface, direction, crosses));
  ray.originInstance = surface.instance;
  return ray;
}

// Spawns a ray from a surface in the direction wi. With `hasEnd`, it ends at the point `end`, whose distance from the
// surface is `distance`: a ray whose origin is moved off the surface has another direction and distance
// (docs/light-transport.md section 6).
Ray shadowRayFrom(Surface surface, vec3 wi, bool crosses, bool hasEnd, vec3 end,
                  inout float distance) {
  vec3 origin = spawnOrigin(surface, wi);
  precise vec3 direction = wi;
  if (kHasFlat && hasEnd && surface.flatSurface) {
    precise vec3 toEnd = end - origin;
    precise float moved = sqrt(dot(toEnd, toEnd));
    if (moved > 0.0) {
      distance = moved;
      direction = toEnd / moved;
    }
  }
  Ray ray = makeRay(origin, direction, spawnSlot(surface, wi, crosses));
  ray.originInstance = surface.instance;
  return ray;
}

#endif
