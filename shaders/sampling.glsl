// Mappings of the unit square to distributions, and local frames: docs/light-transport.md section 2.
#ifndef CANDELA_SAMPLING_GLSL
#define CANDELA_SAMPLING_GLSL
#include "math.glsl"

// Shirley and Chiu's concentric map of the unit square onto the unit disc. z is 1 - x^2 - y^2, without cancellation.
vec3 sampleDisc(vec2 u) {
  vec2 square = 2.0 * u - 1.0;
  bool wide = abs(square.x) > abs(square.y);
  float radius = wide ? square.x : square.y;
  float other = wide ? square.y : square.x;
  if (radius == 0.0) return vec3(0.0, 0.0, 1.0);
  vec2 turned = radius * cosSin((0.25 * kPi) * (other / radius));
  return vec3(wide ? turned : turned.yx, (1.0 - radius) * (1.0 + radius));
}

// Returns the columns tangent, bitangent, n (Duff et al., JCGT 2017). The sign switches at an n.z that common scenes do
// not contain.
mat3 frameAround(vec3 n) {
  float s = n.z > -0.62 ? 1.0 : -1.0;
  float a = -1.0 / (s + n.z);
  float b = n.x * n.y * a;
  return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

// Samples a cosine-weighted direction around z, with pdf z / pi.
vec3 sampleCosineHemisphere(vec2 u) {
  vec3 disc = sampleDisc(u);
  return vec3(disc.xy, sqrt(disc.z));
}

// Samples a uniform direction in the cap of this height (1 - cos of the opening angle) around z, with pdf 1 / (2 pi
// height).
vec3 sampleCap(vec2 u, float height) {
  vec3 disc = sampleDisc(u);
  float q = 1.0 - disc.z;
  // This is height (2 - q height), written so that neither narrow caps nor the whole sphere cancel.
  float scaleSquared = height * (2.0 * disc.z + q * (2.0 - height));
  return vec3(disc.xy * sqrt(scaleSquared), 1.0 - q * height);
}

float capPdf(float height) { return 1.0 / (2.0 * kPi * height); }

// Returns the weights of p1 - p0 and p2 - p0 of a point that is uniform on a triangle.
vec2 sampleTriangle(vec2 u) {
  float s = sqrt(u.x);
  return vec2(s * (1.0 - u.y), s * u.y);
}

// Samples a tent of radius 1 around 0.
float sampleTent(float u) { return u < 0.5 ? sqrt(2.0 * u) - 1.0 : 1.0 - sqrt(2.0 - 2.0 * u); }

// Samples a Gaussian of standard deviation 1 that is lowered to 0 at 4. With v = sqrt(2 min(u, 1 - u)), in which the
// result is smooth at the ends, the distance from the centre is (1 - v) times a rational function, which differs from
// the inverse of the distribution function by less than 7e-8 (fitted to minimise the largest error).
float sampleGaussian(float u) {
  float v = sqrt(2.0 * smaller(u, 1.0 - u));
  float high = 3.99999994 + v * (364.958221 + v * (11881.053 + v * (134855.363 + v * (360932.187 + v * (-170859.749 +
      v * (-207277.861 + v * 78544.3185))))));
  float low = 1.0 + v * (101.038551 + v * (3678.65861 + v * (49756.1084 + v * (182319.125 + v * (-28460.3687 +
      v * (-213344.748 + v * 89172.597))))));
  float distance = (1.0 - v) * (high / low);
  return u < 0.5 ? -distance : distance;
}

// Power heuristic with exponent 2 (Veach 1997). It is safe for any positive pdfs.
float powerHeuristic(float pdf, float otherPdf) {
  float ratio = otherPdf / pdf;
  return 1.0 / (1.0 + ratio * ratio);
}

#endif
