// Ray-primitive tests in single precision: docs/light-transport.md section 4. Each returns the distance of the closest
// valid hit, or kNoHit. `startsHere` is true if the primitive is the ray's origin primitive.
#ifndef CANDELA_GEOMETRY_GLSL
#define CANDELA_GEOMETRY_GLSL
#include "math.glsl"
#include "options.glsl"
#include "shared/render_data.h"

const float kNoHit = kLargestFloat;

struct Ray {
  vec3 origin;
  vec3 direction;  // unit
  uint originSlot; // slot of the origin primitive | kOriginInward, or kNoSlot
  bvec2 along;     // the direction's largest component is x, or y; else it is z
  vec3 shear;      // coefficients of `sheared`; set if the scene has triangles
  uint opacityKey; // of the decisions which transparent triangles it hits; set if the scene has any
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
  return Ray(origin, direction, originSlot, along, shear, 0u);
}

// The shear of Woop, Benthin and Wald (JCGT 2013). It maps the ray's origin to 0 and its direction to (0, 0, 1).
vec3 sheared(vec3 p, Ray ray) {
  precise vec3 q = largestLast(p - ray.origin, ray.along);
  precise vec3 result = vec3(q.xy + ray.shear.xy * q.z, ray.shear.z * q.z);
  return result;
}

// Returns whether the primitive in this slot is the ray's origin primitive.
bool startsOn(Ray ray, uint slot) { return (ray.originSlot & ~kOriginInward) == slot; }

float positiveOrNone(float t) { return t > 0.0 ? t : kNoHit; }

// Tests a sphere that is given by a surface point `anchor` near the scene and k = (anchor - centre) / radius. With
// a = origin - anchor, |o-c|^2 - r^2 = |a|^2 + 2 r a.k and (o-c).d = a.d + r k.d, which avoids the cancellation of a
// radius of 1e5. There are no branches, because the invocations of a subgroup would execute both sides. If the ray
// starts on the sphere, c is 0 and the roots are 0, which is not a hit, and -2 b.
float hitSphere(Ray ray, vec3 anchor, float radius, vec3 k, bool insideOnly, bool startsHere) {
  vec3 a = ray.origin - anchor;
  precise float b = dot(a, ray.direction) + radius * dot(k, ray.direction);
  precise float aa = dot(a, a);
  precise float c = startsHere ? 0.0 : aa + 2.0 * radius * dot(a, k);
  // Far from a small sphere, b*b - c cancels; the distance between the centre and the ray's closest point does not.
  precise vec3 closest = (a + radius * k) - b * ray.direction;
  precise float near2 = b * b - c;
  precise float far2 = radius * radius - dot(closest, closest);
  float discriminant = aa > radius * radius && !startsHere ? far2 : near2;
  float root = sqrt(larger(discriminant, 0.0));
  precise float q = b > 0.0 ? -b - root : root - b;
  precise float other = c / q;
  float first = smaller(q, other);
  float second = larger(q, other);
  float t = first > 0.0 && !insideOnly ? first : second;
  return discriminant >= 0.0 && t > 0.0 ? t : kNoHit;
}

// Woop, Benthin and Wald's watertight test, which needs no epsilon. An edge shared by two triangles gives both the same
// number except for its sign, so no ray passes between them. The distance is the weighted mean of the vertices'
// distances along the ray, so it always lies within the triangle's bounds.
float hitTriangle(Ray ray, vec3 p0, vec3 p1, vec3 p2) {
  precise vec3 a = sheared(p0, ray);
  precise vec3 b = sheared(p1, ray);
  precise vec3 c = sheared(p2, ray);
  precise float u = c.x * b.y - c.y * b.x;
  precise float v = a.x * c.y - a.y * c.x;
  precise float w = b.x * a.y - b.y * a.x;
  bool inside = smaller(u, smaller(v, w)) >= 0.0 || larger(u, larger(v, w)) <= 0.0;
  precise float sum = u + v + w;
  if (!inside || sum == 0.0) return kNoHit;
  precise float t = (u * a.z + v * b.z + w * c.z) / sum;
  return positiveOrNone(t);
}

float hitPlane(Ray ray, vec3 point, vec3 normal) {
  precise float slope = dot(normal, ray.direction);
  if (slope == 0.0) return kNoHit;
  precise float t = dot(normal, point - ray.origin) / slope;
  return positiveOrNone(t);
}

// Computes the distances at which the ray enters and exits each pair of a box's planes. A ray parallel to a pair is
// between its planes either always or never.
void boxSlabs(Ray ray, vec3 low, vec3 high, out vec3 near, out vec3 far) {
  bvec3 parallel = equal(ray.direction, vec3(0.0));
  vec3 inverse = 1.0 / mix(ray.direction, vec3(1.0), parallel);
  precise vec3 t0 = (low - ray.origin) * inverse;
  precise vec3 t1 = (high - ray.origin) * inverse;
  vec3 between = vec3(greaterThanEqual(ray.origin, low)) * vec3(lessThanEqual(ray.origin, high));
  vec3 always = mix(vec3(kLargestFloat), vec3(-kLargestFloat), greaterThan(between, vec3(0.5)));
  near = mix(min(t0, t1), always, parallel);
  far = mix(max(t0, t1), -always, parallel);
}

float hitBox(Ray ray, vec3 low, vec3 high, bool startsHere, bool inward) {
  vec3 near, far;
  boxSlabs(ray, low, high, near, far);
  float entry = largest(near);
  float exit = min(far.x, min(far.y, far.z));
  if (entry > exit) return kNoHit;
  if (startsHere) return inward ? positiveOrNone(exit) : kNoHit;
  return entry > 0.0 ? entry : positiveOrNone(exit);
}

// Frame that cone tests and normals share: z is the height above the base, rho the radius at that height.
struct ConeFrame {
  vec3 axis;
  float height;
  float slope;  // d rho / d z
};

ConeFrame coneFrame(vec3 base, float baseRadius, vec3 apex, float apexRadius) {
  ConeFrame frame;
  vec3 axis = apex - base;
  frame.height = sqrt(dot(axis, axis));
  frame.axis = axis / frame.height;
  frame.slope = (apexRadius - baseRadius) / frame.height;
  return frame;
}

float coneRootInRange(float t, float shift, float z, float dz, float height) {
  float at = z + t * dz;
  return at >= 0.0 && at <= height ? positiveOrNone(t + shift) : kNoHit;
}

// Returns the distance by which the origin is moved before the quadratic is set up, so that its coefficients do not
// cancel: to the point of the ray closest to the middle of the axis, and from there to the point closest to the axis
// itself, but no farther than a hit can be.
float coneShift(ConeFrame cone, vec3 fromBase, vec3 direction, vec3 dAcross, float reach) {
  float toMiddle = -dot(fromBase - 0.5 * cone.height * cone.axis, direction);
  vec3 middle = fromBase + toMiddle * direction;
  float squared = dot(dAcross, dAcross);
  float toAxis = squared > 0.0 ? -dot(middle, dAcross) / squared : 0.0;
  return toMiddle + clamp(toAxis, -reach, reach);
}

float hitCone(Ray ray, vec3 base, float baseRadius, vec3 apex, float apexRadius, bool startsHere) {
  ConeFrame cone = coneFrame(base, baseRadius, apex, apexRadius);
  vec3 fromBase = ray.origin - base;
  precise float dz = dot(ray.direction, cone.axis);
  precise vec3 dAcross = ray.direction - dz * cone.axis;
  float reach = cone.height + baseRadius + apexRadius;
  float shift = startsHere ? 0.0 : coneShift(cone, fromBase, ray.direction, dAcross, reach);
  precise vec3 m = fromBase + shift * ray.direction;
  precise float z = dot(m, cone.axis);
  precise vec3 across = m - z * cone.axis;
  float rho = baseRadius + cone.slope * z;
  float dRho = cone.slope * dz;
  precise float a = dot(dAcross, dAcross) - dRho * dRho;
  precise float b = dot(across, dAcross) - dRho * rho;
  if (startsHere) return a == 0.0 ? kNoHit : coneRootInRange(-2.0 * b / a, 0.0, z, dz, cone.height);
  precise float c = dot(across, across) - rho * rho;
  precise float discriminant = b * b - a * c;
  if (discriminant < 0.0) return kNoHit;
  float root = sqrt(discriminant);
  float q = b > 0.0 ? -b - root : root - b;
  float first = q == 0.0 ? kNoHit : coneRootInRange(c / q, shift, z, dz, cone.height);
  float second = a == 0.0 ? kNoHit : coneRootInRange(q / a, shift, z, dz, cone.height);
  return min(first, second);
}

vec3 sphereNormal(vec3 position, vec3 anchor, float radius, vec3 k) { return unit((position - anchor) / radius + k); }

vec3 coneNormal(vec3 position, vec3 base, float baseRadius, vec3 apex, float apexRadius) {
  ConeFrame cone = coneFrame(base, baseRadius, apex, apexRadius);
  vec3 fromBase = position - base;
  vec3 across = fromBase - dot(fromBase, cone.axis) * cone.axis;
  return unit(unit(across) - cone.slope * cone.axis);
}

// Returns the outward normal of the face that the ray hits, and makes the position's coordinate on that axis exact. The
// face follows from the slabs and not from the position, which on a thin box may be closer to the opposite face.
vec3 boxNormal(Ray ray, vec3 low, vec3 high, bool startsHere, inout vec3 position) {
  vec3 near, far;
  boxSlabs(ray, low, high, near, far);
  bool entering = !startsHere && largest(near) > 0.0;
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
