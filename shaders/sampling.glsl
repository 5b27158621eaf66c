// Warps of the unit square and the frame they are turned into: docs/light-transport.md section 2.
#ifndef CANDELA_SAMPLING_GLSL
#define CANDELA_SAMPLING_GLSL
#include "math.glsl"

// Shirley and Chiu's concentric map of the unit square onto the unit disc. z: 1 - x^2 - y^2, free of cancellation.
vec3 sampleDisc(vec2 u) {
  vec2 square = 2.0 * u - 1.0;
  bool wide = abs(square.x) > abs(square.y);
  float radius = wide ? square.x : square.y;
  float other = wide ? square.y : square.x;
  if (radius == 0.0) return vec3(0.0, 0.0, 1.0);
  vec2 turned = radius * cosSin((0.25 * kPi) * (other / radius));
  return vec3(wide ? turned : turned.yx, (1.0 - radius) * (1.0 + radius));
}

// Columns tangent, bitangent, n: Duff et al., JCGT 2017, switched where no common scene has its normals.
mat3 frameAround(vec3 n) {
  float s = n.z > -0.62 ? 1.0 : -1.0;
  float a = -1.0 / (s + n.z);
  float b = n.x * n.y * a;
  return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

// Cosine-weighted, pdf z / pi.
vec3 sampleCosineHemisphere(vec2 u) {
  vec3 disc = sampleDisc(u);
  return vec3(disc.xy, sqrt(disc.z));
}

// Uniform in the cap of this height (1 - cos of the opening angle) around z, pdf 1 / (2 pi height).
vec3 sampleCap(vec2 u, float height) {
  vec3 disc = sampleDisc(u);
  float q = 1.0 - disc.z;
  // height (2 - q height), written so that neither narrow nor whole caps cancel
  float scaleSquared = height * (2.0 * disc.z + q * (2.0 - height));
  return vec3(disc.xy * sqrt(scaleSquared), 1.0 - q * height);
}

float capPdf(float height) { return 1.0 / (2.0 * kPi * height); }

// Weights of p1 - p0 and p2 - p0 of a point that is uniform on a triangle.
vec2 sampleTriangle(vec2 u) {
  float s = sqrt(u.x);
  return vec2(s * (1.0 - u.y), s * u.y);
}

// Tent of radius 1 around 0.
float sampleTent(float u) { return u < 0.5 ? sqrt(2.0 * u) - 1.0 : 1.0 - sqrt(2.0 - 2.0 * u); }

// Power heuristic with exponent 2 (Veach 1997); safe for any positive pdfs.
float powerHeuristic(float pdf, float otherPdf) {
  float ratio = otherPdf / pdf;
  return 1.0 / (1.0 + ratio * ratio);
}

#endif
