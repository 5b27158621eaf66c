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

// The error of the weights of a triangle's vertices, as a fraction of the sum of the products whose differences they are:
// one product of each, since both are equal but for the weight. It is 2^-23, and the rest is for the rounding of the sum.
const float kWeightError = 1.25 / 8388608.0;

float sumOf(vec3 terms) {
  precise float sum = terms.x + terms.y + terms.z;
  return kTrianglesCoincide ? sortedSum(terms) : sum;
}

// Woop, Benthin and Wald's watertight test, which needs no epsilon. An edge shared by two triangles gives both the same
// number except for its sign, so no ray passes between them. The distance is the weighted mean of the vertices'
// distances along the ray, rounded up by the bound of its error: structures search only as far as the closest hit, and
// would not find a hit that rounding puts before the boxes of its triangle. Of surfaces in one plane, none may always be
// behind the other, so that triangles that coincide with others are not rounded up. Returns the distance of a hit after
// the origin, or kNoHit; with `ofLine`, any number below kNoHit for a hit before it, too. Equal triangles in any order of
// vertices have equal distances if the scene has coincident surfaces.
float triangleDistance(vec3 origin, Shear shear, bool ofLine, bool coincides, vec3 p0, vec3 p1, vec3 p2) {
  precise vec3 a = sheared(p0, origin, shear);
  precise vec3 b = sheared(p1, origin, shear);
  precise vec3 c = sheared(p2, origin, shear);
  precise vec3 weights = vec3(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
  vec3 products = abs(vec3(c.x * b.y, a.x * c.y, b.x * a.y));
  float error = kWeightError * (products.x + products.y + products.z);
  precise vec3 shares = abs(weights);
  float size = sumOf(shares);
  precise vec3 weighted = vec3(shares.x * a.z, shares.y * b.z, shares.z * c.z);
  float moment = sumOf(weighted);
  // If their signs differ, the sum of the weights is less than that of their magnitudes, unless it rounds to the same.
  bool isHit = abs(sumOf(weights)) >= size && size > error && (moment > 0.0 || ofLine);
  float depth = coincides ? 0.0 : abs(a.z - b.z) + abs(b.z - c.z);
  precise float t = (moment + error * depth) / size;
  return isHit ? t : kNoHit;
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
