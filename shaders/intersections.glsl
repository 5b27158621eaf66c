// Tests of spheres, triangles, planes and boxes in single precision: docs/light-transport.md section 4. Each returns the
// distance of the closest valid hit, or kNoHit. `startsHere` is true if the primitive is the ray's origin primitive.
#ifndef CANDELA_INTERSECTIONS_GLSL
#define CANDELA_INTERSECTIONS_GLSL
#include "ray.glsl"

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

// Returns a sum that does not depend on the order of the terms, and is the opposite for terms of opposite sign.
float sortedSum(vec3 terms) {
  float low = smaller(terms.x, smaller(terms.y, terms.z));
  float high = larger(terms.x, larger(terms.y, terms.z));
  float middle = larger(smaller(terms.x, terms.y), smaller(larger(terms.x, terms.y), terms.z));
  precise float sum = (low + high) + middle;
  return sum;
}

// Weights are differences of products. If their sum is less than this fraction of the products, it is no more than their
// rounding, and says nothing: of a small triangle far from the ray, two weights may be 0.
const float kLeastArea = 1.0 / 1048576.0;

// Woop, Benthin and Wald's watertight test, which needs no epsilon. An edge shared by two triangles gives both the same
// number except for its sign, so no ray passes between them. The distance is the weighted mean of the vertices'
// distances along the ray, so it always lies within the triangle's bounds. Returns the distance along the line of the ray,
// which may be negative, or kNoHit if it misses. Equal triangles in any order of vertices have equal distances if the
// scene has coincident surfaces.
float triangleDistance(Ray ray, vec3 p0, vec3 p1, vec3 p2) {
  precise vec3 a = sheared(p0, ray);
  precise vec3 b = sheared(p1, ray);
  precise vec3 c = sheared(p2, ray);
  precise float u = c.x * b.y - c.y * b.x;
  precise float v = a.x * c.y - a.y * c.x;
  precise float w = b.x * a.y - b.y * a.x;
  bool inside = smaller(u, smaller(v, w)) >= 0.0 || larger(u, larger(v, w)) <= 0.0;
  float least = kLeastArea * (abs(c.x * b.y) + abs(a.x * c.y) + abs(b.x * a.y));
  if (kTrianglesCoincide) {
    precise vec3 weighted = vec3(u * a.z, v * b.z, w * c.z);
    float sum = sortedSum(vec3(u, v, w));
    precise float t = sortedSum(weighted) / sum;
    return inside && abs(sum) > least ? t : kNoHit;
  }
  precise float sum = u + v + w;
  if (!inside || abs(sum) <= least) return kNoHit;
  precise float t = (u * a.z + v * b.z + w * c.z) / sum;
  return t;
}

// Returns the distance along the line of the ray, which may be negative, or kNoHit if it is parallel to the plane.
float planeDistance(Ray ray, vec3 point, vec3 normal) {
  precise float slope = dot(normal, ray.direction);
  if (slope == 0.0) return kNoHit;
  precise float t = dot(normal, point - ray.origin) / slope;
  return t;
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

#endif
