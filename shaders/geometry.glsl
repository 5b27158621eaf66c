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

// Returns by how much the barycentric weights of p1 and p2 change along a vector.
vec2 weightsAlong(vec3 vector, vec3 edge1, vec3 edge2) {
  float scale = 1.0 / max(largest(abs(edge1)), largest(abs(edge2)));
  vec3 scaled1 = edge1 * scale;
  vec3 scaled2 = edge2 * scale;
  vec3 scaled = vector * scale;
  vec3 normal = cross(scaled1, scaled2);
  return vec2(dot(cross(scaled, scaled2), normal), dot(cross(scaled1, scaled), normal)) / dot(normal, normal);
}

// The sine of a ray's slope to a plane below which rounding decides where the two meet.
const float kMinSlope = 1.0 / 1048576.0;

// Moves the point of a ray at the distance that the triangle test found to where the ray meets the triangle's plane, and
// returns the barycentric weights of p1 and p2 there (docs/light-transport.md, section 4, "Positions"). A `direction` of 0
// moves the point along the normal instead. `normal` becomes that of the triangle.
vec2 meetTriangle(inout vec3 position, vec3 direction, vec3 p0, vec3 p1, vec3 p2, out vec3 normal) {
  vec3 edge1 = p1 - p0;
  vec3 edge2 = p2 - p0;
  normal = triangleNormal(edge1, edge2);
  vec2 weights = weightsAlong(position - p0, edge1, edge2);
  precise vec3 inPlane = p0 + (weights.x * edge1 + weights.y * edge2);
  precise vec3 offset = position - inPlane;
  float slope = dot(direction, normal);
  if (abs(slope) > kMinSlope) {
    precise vec3 slid = offset - dot(offset, normal) / slope * direction;
    offset = slid;
  }
  precise vec3 met = inPlane + (offset - dot(offset, normal) * normal);
  position = met;
  return weights + weightsAlong(offset, edge1, edge2);
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
