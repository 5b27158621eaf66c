// Ray-primitive tests in single precision: docs/light-transport.md section 4. Each returns the distance of the hit that
// counts, or kNoHit. `leaving` says that the ray starts on this primitive.
#ifndef CANDELA_GEOMETRY_GLSL
#define CANDELA_GEOMETRY_GLSL
#include "math.glsl"
#include "options.glsl"

const float kNoHit = kLargestFloat;

struct Ray {
  vec3 origin;
  vec3 direction;  // unit
  uint leaving;    // slot of the primitive that the ray leaves | kLeavingInward, or kNoSlot
};

float positiveOrNone(float t) { return t > 0.0 ? t : kNoHit; }

// Sphere with a surface point `anchor` near the scene and k = (anchor - centre) / radius: with a = origin - anchor,
// |o-c|^2 - r^2 = |a|^2 + 2 r a.k and (o-c).d = a.d + r k.d, free of the cancellation that a radius of 1e5 brings.
float hitSphere(Ray ray, vec3 anchor, float radius, vec3 k, bool insideOnly, bool leaving) {
  vec3 a = ray.origin - anchor;
  precise float b = dot(a, ray.direction) + radius * dot(k, ray.direction);
  if (leaving) return positiveOrNone(-2.0 * b);
  precise float aa = dot(a, a);
  precise float c = aa + 2.0 * radius * dot(a, k);
  // Far from a small sphere b*b - c cancels; the distance of the ray's closest approach does not.
  precise vec3 closest = (a + radius * k) - b * ray.direction;
  precise float discriminant = aa > radius * radius ? radius * radius - dot(closest, closest) : b * b - c;
  if (discriminant < 0.0) return kNoHit;
  float root = sqrt(discriminant);
  precise float q = b > 0.0 ? -b - root : root - b;
  precise float other = c / q;
  float near = min(q, other);
  float far = max(q, other);
  if (insideOnly) return near <= 0.0 ? positiveOrNone(far) : kNoHit;
  return near > 0.0 ? near : positiveOrNone(far);
}

// Signed volumes of the ray with the triangle's edges: twice the opposite vertices' barycentric weights, up to a common
// factor. Free of scales: no epsilon anywhere. An edge shared by two triangles gives both the same number but for its
// sign, so nothing slips between them.
vec3 edgeVolumes(vec3 v0, vec3 v1, vec3 v2, vec3 direction) {
  precise float w1 = dot(cross(v2 - v0, v2 + v0), direction);
  precise float w2 = dot(cross(v0 - v1, v0 + v1), direction);
  precise float w0 = dot(cross(v1 - v2, v1 + v2), direction);
  return vec3(w0, w1, w2);
}

// The distance is the weighted mean of the vertices' distances along the ray: it never leaves the triangle's bounds.
float hitTriangle(Ray ray, vec3 p0, vec3 p1, vec3 p2) {
  vec3 v0 = p0 - ray.origin;
  vec3 v1 = p1 - ray.origin;
  vec3 v2 = p2 - ray.origin;
  vec3 weights = edgeVolumes(v0, v1, v2, ray.direction);
  bool inside = min(weights.x, min(weights.y, weights.z)) >= 0.0 || max(weights.x, max(weights.y, weights.z)) <= 0.0;
  precise float sum = weights.x + weights.y + weights.z;
  if (!inside || sum == 0.0) return kNoHit;
  precise vec3 along = vec3(dot(v0, ray.direction), dot(v1, ray.direction), dot(v2, ray.direction));
  precise float t = dot(weights, along) / sum;
  return positiveOrNone(t);
}

float hitPlane(Ray ray, vec3 point, vec3 normal) {
  precise float slope = dot(normal, ray.direction);
  if (slope == 0.0) return kNoHit;
  precise float t = dot(normal, point - ray.origin) / slope;
  return positiveOrNone(t);
}

// Distances at which the ray enters and leaves the slabs of a box. A zero component of the direction gives infinities
// and, for an origin on a face, NaN: min and max are ordered so that the other operand wins.
void boxSlabs(Ray ray, vec3 low, vec3 high, out float entry, out float exit) {
  vec3 inverse = 1.0 / ray.direction;
  precise vec3 t0 = (low - ray.origin) * inverse;
  precise vec3 t1 = (high - ray.origin) * inverse;
  entry = -kLargestFloat;
  exit = kLargestFloat;
  for (int axis = 0; axis < 3; ++axis) {
    bool parallel = ray.direction[axis] == 0.0;
    bool outside = ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis];
    float near = parallel ? (outside ? kLargestFloat : -kLargestFloat) : min(t0[axis], t1[axis]);
    float far = parallel ? (outside ? -kLargestFloat : kLargestFloat) : max(t0[axis], t1[axis]);
    entry = max(entry, near);
    exit = min(exit, far);
  }
}

float hitBox(Ray ray, vec3 low, vec3 high, bool leaving, bool inward) {
  float entry, exit;
  boxSlabs(ray, low, high, entry, exit);
  if (entry > exit) return kNoHit;
  if (leaving) return inward ? positiveOrNone(exit) : kNoHit;
  return entry > 0.0 ? entry : positiveOrNone(exit);
}

// What cone tests and normals share: z is the height above the base, rho the radius there.
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

// The quadratic is set up at the ray's closest approach to the base, where its coefficients do not cancel.
float hitCone(Ray ray, vec3 base, float baseRadius, vec3 apex, float apexRadius, bool leaving) {
  ConeFrame cone = coneFrame(base, baseRadius, apex, apexRadius);
  vec3 fromBase = ray.origin - base;
  float shift = leaving ? 0.0 : -dot(fromBase, ray.direction);
  precise vec3 m = fromBase + shift * ray.direction;
  precise float z = dot(m, cone.axis);
  precise float dz = dot(ray.direction, cone.axis);
  precise vec3 across = m - z * cone.axis;
  precise vec3 dAcross = ray.direction - dz * cone.axis;
  float rho = baseRadius + cone.slope * z;
  float dRho = cone.slope * dz;
  precise float a = dot(dAcross, dAcross) - dRho * dRho;
  precise float b = dot(across, dAcross) - dRho * rho;
  precise float c = leaving ? 0.0 : dot(across, across) - rho * rho;
  if (leaving) return a == 0.0 ? kNoHit : coneRootInRange(-2.0 * b / a, 0.0, z, dz, cone.height);
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

// Outward normal of the face that the position is on; the position's coordinate there becomes exact.
vec3 boxNormal(inout vec3 position, vec3 low, vec3 high) {
  vec3 toLow = abs(position - low);
  vec3 toHigh = abs(position - high);
  vec3 nearest = min(toLow, toHigh);
  int axis = nearest.x <= nearest.y && nearest.x <= nearest.z ? 0 : nearest.y <= nearest.z ? 1 : 2;
  bool lower = toLow[axis] < toHigh[axis];
  position[axis] = lower ? low[axis] : high[axis];
  vec3 normal = vec3(0.0);
  normal[axis] = lower ? -1.0 : 1.0;
  return normal;
}

// Barycentric weights of p1 and p2 at a point in the triangle's plane.
vec2 barycentrics(vec3 position, vec3 p0, vec3 p1, vec3 p2) {
  vec3 normal = cross(p1 - p0, p2 - p0);
  float scale = 1.0 / dot(normal, normal);
  return vec2(dot(cross(position - p0, p2 - p0), normal), dot(cross(p1 - p0, position - p0), normal)) * scale;
}

// Moves a point that lies on a flat primitive off it, to the side that `direction` goes to, by more than the rounding of
// its coordinates (after Waechter and Binder, Ray Tracing Gems 6), so that neighbours in the same plane are not met.
vec3 offsetAlong(vec3 position, vec3 normal, vec3 direction) {
  vec3 magnitude = abs(position);
  float distance = largest(magnitude) * (1.0 / 524288.0);
  return position + normal * (dot(normal, direction) < 0.0 ? -distance : distance);
}

#endif
