// Normals and coordinates of the points at which rays hit primitives, and the tests that find these points.
#ifndef CANDELA_GEOMETRY_GLSL
#define CANDELA_GEOMETRY_GLSL
#include "ray.glsl"
#include "intersections.glsl"
#include "cone.glsl"

vec3 sphereNormal(vec3 position, vec3 anchor, float radius, vec3 k) { return unit((position - anchor) / radius + k); }

vec3 coneNormal(vec3 position, vec3 base, float baseRadius, vec3 apex, float apexRadius) {
  ConeFrame cone = coneFrame(base, baseRadius, apex, apexRadius);
  vec3 fromBase = position - base;
  vec3 across = fromBase - dot(fromBase, cone.axis) * cone.axis;
  return unit(unit(across) - cone.slope * cone.axis);
}

// Returns the outward normal of the face that the ray hits at distance t, and makes the position's coordinate on that axis exact. The
// face follows from the slabs and not from the position, which on a thin box may be closer to the opposite face.
vec3 boxNormal(Ray ray, vec3 low, vec3 high, float t, bool startsHere, inout vec3 position) {
  vec3 near, far;
  boxSlabs(ray, low, high, near, far);
  float exit = min(far.x, min(far.y, far.z));
  bool entering = !startsHere && abs(t - largest(near)) <= abs(t - exit);
  vec3 order = entering ? -near : far;
  int axis = order.x <= order.y && order.x <= order.z ? 0 : order.y <= order.z ? 1 : 2;
  bool lower = (ray.direction[axis] > 0.0) == entering;
  position[axis] = lower ? low[axis] : high[axis];
  vec3 normal = vec3(0.0);
  normal[axis] = lower ? -1.0 : 1.0;
  return normal;
}

// Normal of a triangle. The edges are scaled so that their products neither overflow nor underflow.
vec3 triangleNormal(vec3 edge1, vec3 edge2) {
  float scale = 1.0 / max(largest(abs(edge1)), largest(abs(edge2)));
  return unit(cross(edge1 * scale, edge2 * scale));
}

// Returns the barycentric weights of p1 and p2 at a point in the triangle's plane.
vec2 barycentrics(vec3 position, vec3 p0, vec3 p1, vec3 p2) {
  float scale = 1.0 / max(largest(abs(p1 - p0)), largest(abs(p2 - p0)));
  vec3 edge1 = (p1 - p0) * scale;
  vec3 edge2 = (p2 - p0) * scale;
  vec3 toPosition = (position - p0) * scale;
  vec3 normal = cross(edge1, edge2);
  return vec2(dot(cross(toPosition, edge2), normal), dot(cross(edge1, toPosition), normal)) / dot(normal, normal);
}

// Moves a point off the flat primitive on which it lies, to the side to which `direction` points, by more than the
// rounding error of its coordinates (after Waechter and Binder, Ray Tracing Gems 6). Rays therefore do not hit other
// primitives in the same plane.
vec3 offsetAlong(vec3 position, vec3 normal, vec3 direction) {
  float distance = largest(abs(position)) * (1.0 / 4194304.0);
  precise vec3 moved = position + normal * (dot(normal, direction) < 0.0 ? -distance : distance);
  return moved;
}

#endif
